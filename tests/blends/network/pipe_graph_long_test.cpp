// Trees of 2500 nodes as SWC files, with dirt: each becomes one solid for each of its parts.
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <random>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/blends/pipe_graph.h"
#include "dupin/io/graph_file.h"

namespace dupin {
namespace {

constexpr std::size_t kSide = 14, kNodes = 2500;

// A random spanning tree of a jittered lattice, which passes through itself nowhere: (node, its
// parent), parents first.
class DirtyTree {
 public:
  explicit DirtyTree(unsigned seed) : random_(seed) {}

  std::string swc() {
    text_ << "# a tree\n";
    std::vector<std::size_t> order{0};
    std::vector<bool> is_in(kSide * kSide * kSide, false);
    is_in[0] = true;
    write(0, -1, 1.6);
    std::size_t newest = 60;  // that may grow, all of them where these are all walled in
    while (order.size() < kNodes) {
      const std::size_t from =
          order[order.size() - 1 - random_() % std::min(order.size(), newest++)];
      const std::array<std::size_t, 3> at{from % kSide, from / kSide % kSide, from / kSide / kSide};
      const std::size_t axis = random_() % 3, step = axis == 0   ? 1
                                                     : axis == 1 ? kSide
                                                                 : kSide * kSide;
      const bool up = random_() % 2 == 0;
      if (at.at(axis) == (up ? kSide - 1 : 0)) {
        continue;
      }
      const std::size_t to = up ? from + step : from - step;
      if (is_in[to]) {
        continue;
      }
      newest = 60;
      is_in[to] = true;
      order.push_back(to);
      write(to, std::ptrdiff_t(from), uniform(0.5, 1.6));
      soil(to);
    }
    // A part of its own.
    text_ << "90001 0 -100 0 0 1 -1\n90002 0 -100 0 30 1 90001\n90003 0 -80 0 50 1 90002\n";
    return text_.str();
  }

 private:
  double uniform(double low, double high) {
    return low + (high - low) * double(random_()) / 4294967296.0;
  }

  void write(std::size_t node, std::ptrdiff_t parent, double radius) {
    const Vec3 at = 12 * Vec3(double(node % kSide), double(node / kSide % kSide),
                              double(node / kSide / kSide)) +
                    Vec3(uniform(-2, 2), uniform(-2, 2), uniform(-2, 2));
    if (random_() % 40 == 0) {
      radius = random_() % 2 == 0 ? 0 : -1;
    }
    last_ = at;
    text_ << node << " 3 " << at.x() << ' ' << at.y() << ' ' << at.z() << ' ' << radius << ' '
          << parent << '\n';
  }

  // Twins, balls in balls, stubs.
  void soil(std::size_t node) {
    const std::size_t id = 10000 + node;
    switch (random_() % 60) {
      case 0:
        text_ << id << " 3 " << last_.x() << ' ' << last_.y() << ' ' << last_.z() << " 0.4 " << node
              << '\n';
        break;
      case 1:
        text_ << id << " 3 " << last_.x() + 0.05 << ' ' << last_.y() << ' ' << last_.z() << " 0.1 "
              << node << '\n';
        break;
      case 2:
        text_ << id << " 3 " << last_.x() + 1.1 << ' ' << last_.y() << ' ' << last_.z() << " 0.5 "
              << node << '\n';
        break;
      default:
        break;
    }
  }

  std::mt19937 random_;
  std::ostringstream text_;
  Vec3 last_ = Vec3::Zero();
};

TEST(PipeGraphLong, a_dirty_tree_of_2500_nodes_is_one_solid_without_handles) {
  const PipeGraph graph = parse_swc(DirtyTree(18).swc(), "tree.swc");
  ASSERT_GE(graph.nodes.size(), kNodes);
  const PipeNetwork network = assembly_of(graph);
  EXPECT_EQ(network.components, 2);
  EXPECT_EQ(network.cycles, 0);
  EXPECT_LT(network.balls, kNodes / 100);
  EXPECT_GT(network.notes.size(), 50);
  const Built built = build(network.assembly);
  EXPECT_EQ(built.solid.components(), 2);
  EXPECT_EQ(built.solid.euler_number(), 4);
}

}  // namespace
}  // namespace dupin
