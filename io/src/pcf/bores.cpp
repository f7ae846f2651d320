#include "pcf/bores.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "pcf/wall_schedule.h"

namespace dupin::pcf {
namespace {

// 3 1/2 inches, whose outside diameter is called 4 inches, and whose name is the diameter of 3.
constexpr double kRareSize = 3.5;

struct Meaning {
  double diameter = 0;  ///< in millimetres
  std::size_t line = 0;
  const NominalPipe* nominal = nullptr;  ///< if the bore is a name
  bool is_doubtful = false;              ///< a name and an outside diameter of another size
  bool is_odd = false;                   ///< neither
  bool is_used = false;                  ///< by a component that does not say its diameter
};

std::string size_text(const NominalPipe& pipe) {
  return "NPS " + decimal(pipe.inches, kMessageDigits) + ", DN " +
         decimal(pipe.nominal, kMessageDigits) + ", ASME B36.10M";
}

// As most of the file; else it is the size that is not the rare one.
bool is_likely_name(const Meaning& own, std::size_t names, std::size_t diameters) {
  return names == diameters ? own.nominal->inches != kRareSize : names > diameters;
}

}  // namespace

void give_meaning(PcfFile& file, BoreUnit unit, double millimetres, BoreMeaning meaning,
                  std::span<const std::optional<double>> own_radii) {
  std::map<double, Meaning> meanings;
  std::size_t names = 0, diameters = 0;
  for (std::size_t i = 0; i < file.line.components.size(); ++i) {
    const bool is_used = own_radii.empty() || !own_radii[i];
    for (const PipingPort& port : file.line.components[i].ports) {
      if (!port.radius) {
        continue;
      }
      const double bore = 2 * *port.radius;
      auto [found, is_new] = meanings.try_emplace(bore);
      Meaning& own = found->second;
      if (is_new) {
        own = {bore * millimetres, port.line, called(bore, unit)};
        const NominalPipe* outside = of_outside(own.diameter);
        own.is_doubtful = own.nominal != nullptr && outside != nullptr && own.nominal != outside;
        own.is_odd = own.nominal == nullptr && outside == nullptr;
      }
      if (is_used && !own.is_used) {
        own.is_used = true;
        own.line = port.line;
      }
      names += own.nominal != nullptr && !own.is_doubtful ? 1 : 0;
      diameters += own.nominal == nullptr ? 1 : 0;
    }
  }
  for (auto& [bore, own] : meanings) {
    const bool is_name =
        own.nominal != nullptr && (meaning == BoreMeaning::nominal ||
                                   (meaning == BoreMeaning::automatic &&
                                    (!own.is_doubtful || is_likely_name(own, names, diameters))));
    if (is_name) {
      if (own.is_used && own.nominal->outside != own.diameter) {
        file.notes.push_back({own.line, "bore " + decimal(bore, kMessageDigits) +
                                            ": outside diameter " +
                                            decimal(own.nominal->outside, kMessageDigits) +
                                            " mm (" + size_text(*own.nominal) + ")"});
      }
      own.diameter = own.nominal->outside;
    } else if (own.is_used && own.is_odd && meaning != BoreMeaning::outside) {
      file.notes.push_back({own.line, "bore " + decimal(bore, kMessageDigits) +
                                          " is no size of ASME B36.10M; it is taken for an outside "
                                          "diameter"});
    }
  }
  for (PipingComponent& component : file.line.components) {
    for (PipingPort& port : component.ports) {
      if (port.radius) {
        port.radius = meanings.at(2 * *port.radius).diameter / 2;
      }
    }
  }
}

}  // namespace dupin::pcf

namespace dupin {

void give_walls(PcfFile& file, const std::string& schedule) {
  const UsualArithmetic usual;
  const auto refuse = [&](const std::string& why) {
    throw Error(Errc::invalid_argument, why, {}, file.line.source);
  };
  if (!pcf::is_schedule(schedule)) {
    refuse("there is no schedule '" + schedule + "', but " + pcf::schedule_names());
  }
  std::set<double> noted;
  bool is_any = false;
  for (PipingComponent& component : file.line.components) {
    double diameter = 0;
    for (const PipingPort& port : component.ports) {
      diameter = std::max(diameter, 2 * port.radius.value_or(0));
    }
    if (component.wall || diameter == 0) {
      continue;
    }
    const pcf::NominalPipe* const pipe = pcf::of_outside(diameter);
    component.wall = pipe == nullptr ? std::nullopt : pcf::wall_of(*pipe, schedule);
    is_any = is_any || component.wall;
    if (!component.wall && noted.insert(diameter).second) {
      file.notes.push_back(
          {component.line, "outside diameter " + decimal(diameter, kMessageDigits) +
                               " mm is not made in schedule " + schedule + " of ASME B36.10M"});
    }
  }
  if (!is_any) {
    refuse("no component without a wall of its own is of a size that is made in schedule " +
           schedule + " of ASME B36.10M");
  }
}

}  // namespace dupin
