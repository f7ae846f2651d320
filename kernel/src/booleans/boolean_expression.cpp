#include "dupin/kernel/boolean_expression.h"

#include <algorithm>
#include <cctype>
#include <list>
#include <map>
#include <string>
#include <utility>

#include "booleans/combine.h"
#include "booleans/operands.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

std::string quoted(const std::string& name) {
  const bool is_plain = !name.empty() && std::all_of(name.begin(), name.end(), is_name_character);
  return is_plain ? name : '"' + name + '"';
}

// Deeper nesting than anybody writes, and far less than the stack holds.
constexpr int kDeepest = 1000;

}  // namespace

class Expression::Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Expression run() {
    sum();
    if (peek(); at_ < text_.size()) {
      fail(std::string("'+', '-', '&' or the end is expected, not '") + character() + "'");
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(Errc::parse_failed, "in the expression \"" + std::string(text_) + "\": " + message,
                {}, std::to_string(at_ + 1));
  }
  // NUL at the end; one before it is what no rule expects.
  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
      ++at_;
    }
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  void sum() {
    product();
    for (char c = peek(); c == '+' || c == '-'; c = peek()) {
      ++at_;
      product();
      result_.steps_.push_back({c == '+' ? Kind::unite : Kind::subtract, 0});
    }
  }
  void product() {
    term();
    while (peek() == '&') {
      ++at_;
      term();
      result_.steps_.push_back({Kind::intersect, 0});
    }
  }
  // That is next, of as many bytes as UTF-8 has for it.
  [[nodiscard]] std::string character() {
    if (peek() == '\0') {
      return "\\0";
    }
    std::size_t end = at_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) {
      ++end;
    }
    return std::string(text_.substr(at_, end - at_));
  }
  void term() {
    const char c = peek();
    if (c == '(') {
      if (++depth_ > kDeepest) {
        fail("parentheses are nested more than " + std::to_string(kDeepest) + " deep");
      }
      ++at_;
      sum();
      if (peek() != ')') {
        fail("')' is expected");
      }
      ++at_;
      --depth_;
    } else if (c == '"') {
      const std::size_t end = text_.find('"', at_ + 1);
      if (end == std::string_view::npos) {
        fail("the quoted name does not end");
      }
      operand(text_.substr(at_ + 1, end - at_ - 1));
      at_ = end + 1;
    } else if (is_name_character(c)) {
      const std::size_t begin = at_;
      while (at_ < text_.size() && is_name_character(text_[at_])) {
        ++at_;
      }
      operand(text_.substr(begin, at_ - begin));
    } else {
      fail(at_ == text_.size() ? "an operand is expected at the end"
                               : "an operand is expected, not '" + character() + "'");
    }
  }
  void operand(std::string_view name) {
    auto& names = result_.names_;
    const auto [at, is_new] = known_.try_emplace(name, static_cast<std::uint32_t>(names.size()));
    result_.steps_.push_back({Kind::operand, at->second});
    if (is_new) {
      names.emplace_back(name);
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::map<std::string_view, std::uint32_t> known_;  // names, by their places
  Expression result_;
};

Expression Expression::parse(std::string_view text) { return Parser(text).run(); }

std::string Expression::text() const {
  // Of words that are spliced: texts would be copied at every step.
  struct Part {
    std::list<std::string> words;
    Kind kind;
  };
  const auto enclose = [](Part& part, bool needed) {
    if (needed) {
      part.words.emplace_front("(");
      part.words.emplace_back(")");
    }
  };
  const auto is_sum = [](const Part& part) {
    return part.kind == Kind::unite || part.kind == Kind::subtract;
  };
  std::vector<Part> stack;
  for (const Step& step : steps_) {
    if (step.kind == Kind::operand) {
      stack.push_back({{quoted(names_[step.operand])}, step.kind});
      continue;
    }
    Part right = std::move(stack.back());
    stack.pop_back();
    Part& left = stack.back();
    const bool is_product = step.kind == Kind::intersect;
    enclose(left, is_product && is_sum(left));
    enclose(right, is_sum(right) || (is_product && right.kind == Kind::intersect));
    left.words.emplace_back(is_product ? " & " : step.kind == Kind::unite ? " + " : " - ");
    left.words.splice(left.words.end(), right.words);
    left.kind = step.kind;
  }
  std::string text;
  for (const Part& part : stack) {
    for (const std::string& word : part.words) {
      text += word;
    }
  }
  return text;
}

bool Expression::contains(const std::vector<bool>& inside) const {
  if (inside.size() != names_.size()) {
    throw Error(Errc::invalid_argument, "an expression of " + std::to_string(names_.size()) +
                                            " operands is asked about a place in " +
                                            std::to_string(inside.size()) +
                                            " of them; say of each whether it is inside");
  }
  std::vector<bool> stack;
  for (const Step& step : steps_) {
    if (step.kind == Kind::operand) {
      stack.push_back(inside[step.operand]);
      continue;
    }
    const bool right = stack.back();
    stack.pop_back();
    const bool left = stack.back();
    stack.back() = step.kind == Kind::unite       ? left || right
                   : step.kind == Kind::intersect ? left && right
                                                  : left && !right;
  }
  return !stack.empty() && stack.back();
}

std::vector<Solid> booleans::operands_of(const Expression& expression,
                                         const std::map<std::string, Solid>& operands) {
  std::vector<Solid> solids;
  for (const std::string& name : expression.names()) {
    const auto at = operands.find(name);
    if (at == operands.end()) {
      throw Error(Errc::invalid_argument,
                  "the expression names an operand that is not given: '" + name + "'", name);
    }
    solids.push_back(at->second);
  }
  return solids;
}

Solid evaluate(const Expression& expression, const std::map<std::string, Solid>& operands,
               const BooleanOptions& options) {
  const UsualArithmetic usual;
  const std::vector<Solid> solids = booleans::operands_of(expression, operands);
  arrangement::BooleanRule rule;
  while (rule.group_of_operand.size() < solids.size()) {
    rule.group_of_operand.push_back(rule.groups++);
  }
  rule.inside = [&expression](std::span<const int> counts) {
    std::vector<bool> inside;
    for (const int count : counts) {
      inside.push_back(count > 0);
    }
    return expression.contains(inside);
  };
  return Solid(std::make_shared<const mesh::ExactMesh>(booleans::combine(solids, rule, options)));
}

}  // namespace dupin
