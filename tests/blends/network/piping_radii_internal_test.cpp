#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "network/piping_radii.h"

namespace dupin::network {
namespace {

// Components with so many ends of these radii (0: none), each joined to the next one's first.
struct Chain {
  explicit Chain(const std::vector<std::vector<double>>& radii) {
    for (const auto& own : radii) {
      PipingComponent component;
      component.name = "c" + std::to_string(line.components.size());
      for (std::size_t k = 0; k < own.size(); ++k) {
        LinePort port{line.components.size(), k, Vec3::Zero(), {}, {}, ports.size() + 1};
        if (own[k] > 0) {
          port.radius = own[k];
        }
        if (k == 0 && !ports.empty()) {
          pairs.push_back({ports.size() - 1, ports.size(), 0});
        }
        ports.push_back(port);
        component.ports.emplace_back();
      }
      line.components.push_back(component);
    }
    infer_radii(line, pairs, ports, notes);
  }
  [[nodiscard]] std::vector<double> radii() const {
    std::vector<double> result;
    for (const LinePort& port : ports) {
      result.push_back(port.radius.value_or(0));
    }
    return result;
  }
  PipingLine line;
  std::vector<LinePort> ports;
  std::vector<PortPair> pairs;
  LineNotes notes{"a.pcf", false};
};

using testing::ElementsAre;

TEST(PipingRadii, come_over_joints_and_through_pipes) {
  EXPECT_THAT(Chain({{5, 5}, {0, 0}, {0, 0}}).radii(), ElementsAre(5, 5, 5, 5, 5, 5));
  EXPECT_THAT(Chain({{0, 0}, {0, 0}, {5, 4}}).radii(), ElementsAre(5, 5, 5, 5, 5, 4));
}

TEST(PipingRadii, of_the_joint_come_before_those_of_the_component) {
  EXPECT_THAT(Chain({{5, 5}, {0, 0, 0}, {3, 3}}).radii(), ElementsAre(5, 5, 5, 5, 3, 3, 3));
}

TEST(PipingRadii, are_none_where_none_is_near) {
  EXPECT_THAT(Chain({{0, 0}, {0, 0}}).radii(), ElementsAre(0, 0, 0, 0));
}

TEST(PipingRadii, are_noted_once_for_each_component) {
  Chain chain({{5, 5}, {0, 0}, {4, 0}});
  const auto notes = std::move(chain.notes).take();
  ASSERT_EQ(notes.size(), 2);
  EXPECT_THAT(notes[0].text, testing::HasSubstr("c1: has no bore at line 3"));
}

}  // namespace
}  // namespace dupin::network
