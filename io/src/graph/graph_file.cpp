#include "dupin/io/graph_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <sstream>
#include <unordered_map>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "text/byte_order_mark.h"
#include "text/line_counter.h"
#include "text/lower_case.h"
#include "text/text_scanner.h"
#include "text/utf16.h"

namespace dupin {
namespace {

using text::TextScanner;

// Of a text, in which a line is looked for that tells its format: comments come before it.
constexpr std::size_t kFirstLines = 1 << 16;

constexpr std::int64_t kLargestNumber = std::numeric_limits<std::int64_t>::max() / 16;

std::string extension_of(const std::filesystem::path& file) {
  return text::lower_case(file.extension().string());
}

// Ones that are not finite, as programs print them ("nan", "-inf", 1e400), are left to those who
// clean the graph.
double any_number(TextScanner& scanner, std::string_view expected) {
  const std::string word(scanner.peek());
  const double value = std::strtod(word.c_str(), nullptr);
  if (std::isfinite(value)) {
    return scanner.number(expected);
  }
  scanner.skip_number(expected);
  return value;
}

Vec3 coordinates(TextScanner& scanner) {
  Vec3 result;
  for (double& x : result) {
    x = any_number(scanner, "a coordinate");
  }
  return result;
}

// A line that refers to what may come later.
struct Link {
  std::int64_t from = 0, to = 0;
  std::size_t position = 0, line = 0;
};

class Faults {
 public:
  Faults(const TextScanner& scanner, std::vector<SourceNote>* notes)
      : scanner_(scanner), notes_(notes) {}

  void add(std::size_t position, std::size_t line, const std::string& text) const {
    if (notes_ == nullptr) {
      scanner_.fail_at(position, text);
    }
    notes_->push_back({line, text + "; left out", true});
  }

 private:
  const TextScanner& scanner_;
  std::vector<SourceNote>* notes_;
};

enum class GraphFormat : std::uint8_t { none, swc, graph };

bool is_number(const std::string& word) {
  char* end = nullptr;
  std::strtod(word.c_str(), &end);
  return end == word.c_str() + word.size();
}

// Of the first line that says something.
GraphFormat format_of_text(std::string_view text) {
  std::istringstream lines{std::string(text.substr(text::byte_order_mark(text), kFirstLines))};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    const std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
    if (all.empty()) {
      continue;
    }
    const bool are_numbers = std::all_of(all.begin() + 1, all.end(), is_number);
    if (!are_numbers) {
      return GraphFormat::none;
    }
    return (all[0] == "n" && (all.size() == 4 || all.size() == 5)) ||
                   (all[0] == "c" && all.size() == 3)
               ? GraphFormat::graph
           : all.size() == 7 && is_number(all[0]) ? GraphFormat::swc
                                                  : GraphFormat::none;
  }
  return GraphFormat::none;
}

}  // namespace

bool is_graph_text(std::string_view text) { return format_of_text(text) != GraphFormat::none; }

bool is_graph_file(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  return extension == ".swc" || extension == ".graph";
}

PipeGraph parse_swc(std::string_view text, const std::string& source,
                    std::vector<SourceNote>* notes) {
  const UsualArithmetic usual;
  TextScanner scanner(text, source, '#');
  const Faults faults(scanner, notes);
  text::LineCounter lines(text);
  PipeGraph graph{source, {}, {}};
  std::unordered_map<std::int64_t, std::size_t> position_of;
  std::vector<Link> links;
  while (!scanner.at_end()) {
    scanner.skip_space();
    const std::size_t start = scanner.position(), line = lines.at(start);
    const std::int64_t id = scanner.integer(0, kLargestNumber, "the node's id, a whole number");
    scanner.integer(-kLargestNumber, kLargestNumber, "the node's type, a whole number");
    const Vec3 center = coordinates(scanner);
    const double radius = any_number(scanner, "the node's radius");
    const std::int64_t parent =
        scanner.integer(-1, kLargestNumber, "the parent's id, or -1 for none, a whole number");
    scanner.end_line("the end of the line after id, type, x, y, z, radius and parent");
    const std::string name = std::to_string(id);
    if (!position_of.try_emplace(id, graph.nodes.size()).second) {
      faults.add(start, line, "node " + name + ": the id occurs before");
      continue;
    }
    if (parent >= 0) {
      links.push_back({std::int64_t(graph.nodes.size()), parent, start, line});
    }
    graph.nodes.push_back({name, center, radius, line});
  }
  for (const Link& link : links) {
    const auto parent = position_of.find(link.to);
    if (parent == position_of.end()) {
      faults.add(link.position, link.line,
                 "node " + graph.nodes[std::size_t(link.from)].name + ": there is no parent " +
                     std::to_string(link.to));
    } else {
      graph.edges.push_back({parent->second, std::size_t(link.from), link.line});
    }
  }
  return graph;
}

PipeGraph parse_graph(std::string_view text, const std::string& source,
                      std::vector<SourceNote>* notes) {
  const UsualArithmetic usual;
  TextScanner scanner(text, source, '#');
  const Faults faults(scanner, notes);
  text::LineCounter lines(text);
  PipeGraph graph{source, {}, {}};
  std::vector<Link> links;
  while (!scanner.at_end()) {
    scanner.skip_space();
    const std::size_t start = scanner.position(), line = lines.at(start);
    if (scanner.take("n")) {
      GraphNode node{std::to_string(graph.nodes.size()), coordinates(scanner), {}, line};
      if (!scanner.at_line_end()) {
        node.radius = any_number(scanner, "the node's radius");
      }
      graph.nodes.push_back(std::move(node));
    } else if (scanner.take("c")) {
      const std::int64_t from =
          scanner.integer(0, kLargestNumber, "the number of a node, a whole number");
      const std::int64_t to =
          scanner.integer(0, kLargestNumber, "the number of a node, a whole number");
      links.push_back({from, to, start, line});
    } else {
      scanner.fail("\"n x y z [radius]\" for a node or \"c i j\" for an edge");
    }
    scanner.end_line("the end of the line");
  }
  const auto count = std::int64_t(graph.nodes.size());
  for (const Link& link : links) {
    if (std::max(link.from, link.to) >= count) {
      faults.add(link.position, link.line,
                 "edge " + std::to_string(link.from) + "-" + std::to_string(link.to) +
                     ": there is no node " + std::to_string(std::max(link.from, link.to)) +
                     ", only " + std::to_string(count) + " from 0 on");
    } else {
      graph.edges.push_back({std::size_t(link.from), std::size_t(link.to), link.line});
    }
  }
  return graph;
}

PipeGraph parse_graph_file(std::string_view text, const std::string& source,
                           std::vector<SourceNote>* notes) {
  const UsualArithmetic usual;
  text::refuse_utf16(text, source);
  const bool is_swc = is_graph_file(source) ? extension_of(source) == ".swc"
                                            : format_of_text(text) == GraphFormat::swc;
  return is_swc ? parse_swc(text, source, notes) : parse_graph(text, source, notes);
}

}  // namespace dupin
