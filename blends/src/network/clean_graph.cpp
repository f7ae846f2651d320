#include "network/clean_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::network {
namespace {

using assembly::kLargest;

bool is_usable(double radius) { return radius > 0 && radius <= kLargest; }

class Cleaning {
 public:
  Cleaning(const PipeGraph& graph, const PipeGraphOptions& options)
      : graph_(graph), options_(options), stands_for_(graph.nodes.size()) {
    std::iota(stands_for_.begin(), stands_for_.end(), std::size_t{0});
    for (const GraphNode& node : graph.nodes) {
      radius_.push_back(node.radius);
      is_left_.push_back(true);
    }
  }

  CleanGraph run() {
    drop_absurd_nodes();
    merge_duplicates();
    take_edges();
    fill_in_radii();
    while (merge_nested()) {
    }
    return compact();
  }

 private:
  void note(std::size_t line, std::string text, bool is_refusal = false) {
    result_.notes.push_back({line, std::move(text), is_refusal});
  }

  void refuse(std::size_t line, const std::string& text) {
    if (!options_.keep_going) {
      const std::string place =
          line > 0 ? graph_.source + ":" + std::to_string(line) : graph_.source;
      throw Error(Errc::invalid_argument, text, {}, place);
    }
    note(line, text + "; left out", true);
  }

  [[nodiscard]] std::string named(std::size_t node) const {
    return "node " + graph_.nodes[node].name;
  }

  [[nodiscard]] std::string named(const GraphEdge& edge) const {
    return "edge " + graph_.nodes[edge.from].name + "-" + graph_.nodes[edge.to].name;
  }

  std::size_t representative(std::size_t node) {
    while (stands_for_[node] != node) {
      stands_for_[node] = stands_for_[stands_for_[node]];
      node = stands_for_[node];
    }
    return node;
  }

  void drop_absurd_nodes() {
    std::vector<bool> is_used(graph_.nodes.size(), false);
    for (const GraphEdge& edge : graph_.edges) {
      for (const std::size_t node : {edge.from, edge.to}) {
        if (node < is_used.size()) {
          is_used[node] = true;
        }
      }
    }
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      const GraphNode& node = graph_.nodes[i];
      const bool is_placed =
          node.center.lpNorm<Eigen::Infinity>() <= kLargest && node.center.allFinite();
      const bool is_bounded = !node.radius || std::abs(*node.radius) <= kLargest;
      const bool is_fine = node.radius && *node.radius > 0 && *node.radius < kLeastRadius;
      if (is_placed && is_bounded && !is_fine) {
        continue;
      }
      is_left_[i] = false;
      const std::string why =
          named(i) + ": " +
          (is_placed && is_bounded
               ? "its radius must be at least " + decimal(kLeastRadius, kMessageDigits) + ", not " +
                     decimal_at_most(*node.radius)
               : (is_placed ? "its radius" : "its coordinates") +
                     std::string(" must be finite and at most 1e12 in size"));
      if (is_used[i]) {
        refuse(node.line, why);
      } else {
        note(node.line, why + "; dropped, as it has no edge");
      }
    }
  }

  // The first of them stays, with the largest radius.
  void merge_duplicates() {
    std::map<std::array<double, 3>, std::size_t> first;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      if (!is_left_[i]) {
        continue;
      }
      const Vec3 at = graph_.nodes[i].center + Vec3::Zero();  // no -0
      const auto [found, is_new] = first.try_emplace({at.x(), at.y(), at.z()}, i);
      if (!is_new) {
        note(graph_.nodes[i].line,
             named(i) + ": at the same place as " + named(found->second) + "; merged with it");
        stands_for_[i] = found->second;
        radius_[found->second] = std::max(radius_[found->second], radius_[i]);
      }
    }
  }

  void take_edges() {
    for (const GraphEdge& edge : graph_.edges) {
      if (edge.from >= graph_.nodes.size() || edge.to >= graph_.nodes.size()) {
        refuse(edge.line, "an edge to a node that does not exist");
      } else if (!is_left_[edge.from] || !is_left_[edge.to]) {
        leave_out(edge);
      } else if (edge.from == edge.to) {
        note(edge.line, named(edge) + ": leads from a node to itself; dropped");
      } else {
        take(edge);
      }
    }
  }

  void leave_out(const GraphEdge& edge) {
    note(edge.line, named(edge) + ": one of its nodes was left out; left out", true);
  }

  void take(const GraphEdge& edge) {
    const std::size_t from = representative(edge.from), to = representative(edge.to);
    if (from == to) {
      note(edge.line, named(edge) + ": has no length; dropped");
    } else if (!pairs_.insert(std::minmax(from, to)).second) {
      note(edge.line, named(edge) + ": joins nodes that are joined already; dropped");
    } else {
      edges_.push_back({from, to, edge.line});
    }
  }

  // A node without one takes the option's, else that of the nearest node, counted in edges, that
  // has one.
  void fill_in_radii() {
    std::vector<std::vector<std::size_t>> neighbours(graph_.nodes.size());
    for (const GraphEdge& edge : edges_) {
      neighbours[edge.from].push_back(edge.to);
      neighbours[edge.to].push_back(edge.from);
    }
    std::vector<std::size_t> queue;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      if (neighbours[i].empty()) {
        continue;
      }
      if (!radius_[i] && !options_.radius) {
        is_left_[i] = false;
        refuse(graph_.nodes[i].line,
               named(i) +
                   ": has no radius; write one after its coordinates, or give one for all "
                   "such nodes with --radius");
        continue;
      }
      const bool is_given = radius_[i] && is_usable(*radius_[i]);
      if (!is_given && options_.radius) {
        if (radius_[i]) {
          note(graph_.nodes[i].line, named(i) + ": its radius of " + decimal(*radius_[i]) +
                                         " is not positive; given that of --radius, " +
                                         decimal(*options_.radius));
        }
        radius_[i] = options_.radius;
      }
      if (is_given || options_.radius) {
        queue.push_back(i);
      }
    }
    spread(queue, neighbours);
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      if (is_left_[i] && !neighbours[i].empty() && !is_usable(radius_[i].value_or(0))) {
        is_left_[i] = false;
        refuse(graph_.nodes[i].line,
               named(i) +
                   ": its radius is not positive, and no node that it hangs together with "
                   "has one that is; --radius would be taken instead");
      }
    }
    drop_edges_of_lost_nodes();
  }

  void spread(std::vector<std::size_t>& queue,
              const std::vector<std::vector<std::size_t>>& neighbours) {
    for (std::size_t k = 0; k < queue.size(); ++k) {
      for (const std::size_t other : neighbours[queue[k]]) {
        if (is_left_[other] && !is_usable(*radius_[other])) {
          note(graph_.nodes[other].line, named(other) + ": its radius of " +
                                             decimal(*radius_[other]) + " is not positive; given " +
                                             "that of " + named(queue[k]) + ", " +
                                             decimal(*radius_[queue[k]]));
          radius_[other] = radius_[queue[k]];
          queue.push_back(other);
        }
      }
    }
  }

  void drop_edges_of_lost_nodes() {
    std::vector<GraphEdge> kept;
    for (const GraphEdge& edge : edges_) {
      if (is_left_[edge.from] && is_left_[edge.to]) {
        kept.push_back(edge);
      } else {
        leave_out(edge);
      }
    }
    edges_ = std::move(kept);
  }

  // A ball inside of its neighbour's goes into it, with all its edges.
  bool merge_nested() {
    bool is_any = false;
    for (const GraphEdge& edge : edges_) {
      const std::size_t a = representative(edge.from), b = representative(edge.to);
      const double length = (graph_.nodes[a].center - graph_.nodes[b].center).norm();
      if (a == b || std::abs(*radius_[a] - *radius_[b]) < length) {
        continue;
      }
      const auto [outer, inner] = *radius_[a] >= *radius_[b] ? std::pair(a, b) : std::pair(b, a);
      note(graph_.nodes[inner].line,
           named(inner) + ": its ball lies in that of " + named(outer) + "; merged with it");
      stands_for_[inner] = outer;
      is_any = true;
    }
    if (is_any) {
      std::vector<GraphEdge> before = std::exchange(edges_, {});
      pairs_.clear();
      for (const GraphEdge& edge : before) {
        take(edge);
      }
    }
    return is_any;
  }

  CleanGraph compact() {
    std::vector<std::size_t> degree(graph_.nodes.size()), place(graph_.nodes.size());
    for (const GraphEdge& edge : edges_) {
      ++degree[edge.from];
      ++degree[edge.to];
    }
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      const GraphNode& node = graph_.nodes[i];
      if (degree[i] > 0) {
        place[i] = result_.nodes.size();
        result_.nodes.push_back({node.name, node.center, *radius_[i], node.line});
      } else if (is_left_[i] && stands_for_[i] == i) {
        note(node.line, named(i) + ": has no edge; dropped");
      }
    }
    for (const GraphEdge& edge : edges_) {
      result_.edges.push_back({place[edge.from], place[edge.to], edge.line});
    }
    if (edges_.empty()) {
      throw Error(Errc::invalid_argument, "of the graph, no edge with two different nodes is left",
                  {}, graph_.source);
    }
    return std::move(result_);
  }

  const PipeGraph& graph_;
  const PipeGraphOptions& options_;
  std::vector<std::size_t> stands_for_;  // by node, itself if it is not merged
  std::vector<std::optional<double>> radius_;
  std::vector<bool> is_left_;
  std::vector<GraphEdge> edges_;
  std::set<std::pair<std::size_t, std::size_t>> pairs_;
  CleanGraph result_;
};

}  // namespace

CleanGraph cleaned(const PipeGraph& graph, const PipeGraphOptions& options) {
  return Cleaning(graph, options).run();
}

}  // namespace dupin::network
