#include "tiles/united_districts.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "dupin/io/mesh_file.h"
#include "dupin/io/stl_stream.h"
#include "dupin/kernel/parallel.h"
#include "input.h"

namespace dupin::cli {
namespace {

std::vector<Solid> selected(std::span<const Solid> operands,
                            const std::vector<std::size_t>& members) {
  std::vector<Solid> solids;
  solids.reserve(members.size());
  for (const std::size_t i : members) {
    solids.push_back(operands[i]);
  }
  return solids;
}

Eigen::AlignedBox3d box_of(const StlFile& file) {
  Eigen::AlignedBox3d box;
  file.visit([&](std::span<const Facet> facets) {
    for (const Facet& facet : facets) {
      for (std::size_t k = 0; k < facet.size(); k += 3) {
        box.extend(Vec3(facet[k], facet[k + 1], facet[k + 2]));
      }
    }
  });
  return box;
}

TriMesh mesh_in(const std::string& path) {
  return is_stl_file(path) ? StlFile(path).mesh() : read_mesh_input(path);
}

/// A union in the making.
class UnionInTiles {
 public:
  UnionInTiles(const TiledUnion& task, const OperandFiles& files)
      : task_(task),
        files_(files),
        districts_(
            operand_districts(files.boxes, district_margin(task.to, task.rounding, task.contacts))),
        rounding_(rounding_of_districts(task.rounding, districts_.boxes)),
        repairs_(task.files.size()) {}

  OutputReport run() {
    const std::vector<double> triangles = triangles_of_districts();
    const std::vector<std::size_t> ends = ends_of_tiles(
        task_.tiles, {.districts = districts_.boxes, .triangles = triangles, .source = "operands"});
    DistrictFile file(task_.to);
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
      tell(task_.progress, "unite", double(begin) / double(districts_.boxes.size()));
      std::vector<std::optional<DistrictOutput>> tile(end - begin);
      for_each_in_parallel(tile.size(), [&](std::size_t i) { tile[i] = made(begin + i); });
      for (std::optional<DistrictOutput>& district : tile) {
        file.append(*std::exchange(district, std::nullopt));
      }
      begin = end;
    }
    OutputReport report = file.commit({files_.unit, {}});
    report.repairs = repairs_in(task_.files, repairs_);
    return report;
  }

 private:
  [[nodiscard]] std::vector<double> triangles_of_districts() const {
    std::vector<double> triangles;
    triangles.reserve(districts_.operands.size());
    for (const std::vector<std::size_t>& operands : districts_.operands) {
      double own = 0;
      for (const std::size_t i : operands) {
        own += static_cast<double>(files_.triangles[i]);
      }
      triangles.push_back(own);
    }
    return triangles;
  }

  DistrictOutput made(std::size_t district) {
    std::vector<Solid> operands;
    for (const std::size_t i : districts_.operands[district]) {
      operands.push_back(
          operand_of(mesh_in(task_.files[i]), task_.files[i], task_.are_repaired, repairs_[i]));
    }
    const Solid solid = unite(operands, {task_.contacts.policy(), {}});
    operands.clear();
    return district_output(solid, districts_.boxes, district, task_.to, rounding_, task_.contacts);
  }

  const TiledUnion& task_;
  const OperandFiles& files_;
  OperandDistricts districts_;
  RoundingOptions rounding_;
  std::vector<RepairReport> repairs_;  // per operand, each of which one thread mends
};

}  // namespace

Eigen::AlignedBox3d box_of(const TriMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      box.extend(mesh.points[corner]);
    }
  }
  return box;
}

OperandDistricts operand_districts(std::span<const Eigen::AlignedBox3d> boxes,
                                   const DistrictMargin& margin) {
  Boxes wide(boxes.begin(), boxes.end());
  double largest = 0;
  for (const Eigen::AlignedBox3d& box : wide) {
    largest =
        box.isEmpty()
            ? largest
            : std::max({largest, box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()});
  }
  const double reach = margin.absolute + margin.relative * largest;
  for (Eigen::AlignedBox3d& box : wide) {
    if (!box.isEmpty()) {
      box = Eigen::AlignedBox3d(box.min().array() - reach, box.max().array() + reach);
    }
  }
  OperandDistricts result;
  const std::vector<std::uint32_t> of_box = districts_of(wide);
  std::vector<std::optional<std::size_t>> place(boxes.size());  // by number
  for (std::size_t i = 0; i < wide.size(); ++i) {
    if (wide[i].isEmpty()) {
      continue;
    }
    std::optional<std::size_t>& known = place[of_box[i]];
    if (!known) {
      known = result.operands.size();
      result.operands.emplace_back();
      result.boxes.emplace_back();
    }
    result.operands[*known].push_back(i);
    result.boxes[*known].push_back(wide[i]);
  }
  if (result.operands.empty()) {
    result.operands.emplace_back();
    result.boxes.emplace_back();
  }
  for (std::size_t i = 0; i < wide.size(); ++i) {
    if (wide[i].isEmpty()) {
      result.operands.front().push_back(i);
    }
  }
  std::ranges::sort(result.operands.front());
  return result;
}

std::vector<Solid> united_districts(std::span<const Solid> operands,
                                    const OperandDistricts& districts,
                                    const BooleanOptions& options) {
  if (districts.operands.size() == 1) {
    return {unite(operands, options)};
  }
  tell(options.progress, "unite");
  std::vector<Solid> solids(districts.operands.size());
  for_each_in_parallel(solids.size(), [&](std::size_t i) {
    solids[i] = unite(selected(operands, districts.operands[i]), {options.contacts, {}});
  });
  return solids;
}

OperandFiles survey(const std::vector<std::string>& files, const Progress& progress) {
  tell(progress, "read");
  OperandFiles result;
  result.boxes.resize(files.size());
  result.triangles.resize(files.size());
  std::vector<StatedUnit> units(files.size());
  for_each_in_parallel(files.size(), [&](std::size_t i) {
    if (is_stl_file(files[i])) {
      const StlFile file(files[i]);
      units[i] = {files[i], file.unit()};
      result.boxes[i] = box_of(file);
      result.triangles[i] = file.count();
      return;
    }
    const Input input = read_input(files[i]);
    units[i] = {input.name, input.unit()};
    const TriMesh mesh = read_mesh(input.bytes, input.name);
    result.boxes[i] = box_of(mesh);
    result.triangles[i] = mesh.triangles.size();
  });
  result.unit = common_unit(units);
  return result;
}

OutputReport unite_in_tiles(const TiledUnion& task, const OperandFiles& files) {
  return UnionInTiles(task, files).run();
}

}  // namespace dupin::cli
