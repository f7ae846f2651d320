#include "junction/hub_advice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::junction {
namespace {

constexpr double kPart = 0.01;

std::string number(double x) { return decimal_at_least(x); }

JunctionOptions with_smoothness(JunctionOptions options, double smoothness) {
  options.smoothness = smoothness;
  return options;
}

// Ends that many times their setbacks further back along their axes, none where a cone would end
// before.
std::optional<std::vector<Ring>> further_back(std::span<const Ring> ends,
                                              const std::vector<double>& setbacks, double times) {
  std::vector<Ring> result(ends.begin(), ends.end());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double way = times * setbacks[i];
    result[i].center -= way * result[i].normal;
    result[i].radius -= way * result[i].slope;
    if (!(result[i].radius > 0)) {
      return std::nullopt;
    }
  }
  return result;
}

bool is_enough(std::span<const Ring> ends, const JunctionSearch& found, const JunctionNeed& need) {
  return found.junction && (!need || need(ends, *found.junction));
}

class Setbacks {
 public:
  Setbacks(std::span<const Ring> ends, const JunctionOptions& options, std::vector<double> first,
           const JunctionNeed& need)
      : ends_(ends), options_(options), setbacks_(std::move(first)), need_(need) {}

  // What would do, or nothing if nothing was found.
  std::optional<std::vector<double>> run() {
    double much = 1, little = 0;
    if (!grow(much, little)) {
      return std::nullopt;
    }
    while (much - little > kPart / 2 * much) {
      const double middle = (much + little) / 2;
      (does(middle) ? much : little) = middle;
    }
    std::ranges::for_each(setbacks_, [&](double& setback) { setback *= much; });
    return as_printed() ? std::optional(setbacks_) : std::nullopt;
  }

 private:
  // Until it does: by what is still missing, or, where something else is wrong, as much again.
  bool grow(double& much, double& little) {
    constexpr int kMost = 12;
    for (int i = 0; i < kMost; ++i) {
      const auto ends = further_back(ends_, setbacks_, much);
      if (!ends) {
        return false;
      }
      const JunctionSearch found = search_junction(*ends, options_);
      if (found.junction && is_enough(*ends, found, need_)) {
        return true;
      }
      if (found.setbacks.size() == setbacks_.size()) {
        for (std::size_t k = 0; k < setbacks_.size(); ++k) {
          setbacks_[k] = much * setbacks_[k] + found.setbacks[k];
        }
        much = 1;
        little = 0;
      } else {
        little = much;
        much *= 1.5;
      }
    }
    return false;
  }

  // The numbers that are printed are a little larger, each by a part of its own.
  bool as_printed() {
    constexpr int kMost = 8;
    constexpr double kMore = 1 + kPart / 2 / kMost;
    for (int i = 0; i < kMost; ++i) {
      for (double& setback : setbacks_) {
        setback = setback > 0 ? std::stod(number(i == 0 ? setback : kMore * setback)) : 0;
      }
      if (does(1)) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool does(double times) const {
    const auto ends = further_back(ends_, setbacks_, times);
    return ends && is_enough(*ends, search_junction(*ends, options_), need_);
  }

  std::span<const Ring> ends_;
  const JunctionOptions& options_;
  std::vector<double> setbacks_;
  const JunctionNeed& need_;
};

std::string list_of(std::span<const Ring> ends, const std::vector<double>& setbacks) {
  constexpr std::ptrdiff_t kMost = 12;
  std::string result;
  std::ptrdiff_t named = 0;
  const auto all = std::ranges::count_if(setbacks, [](double s) { return s > 0; });
  for (std::size_t i = 0; i < setbacks.size(); ++i) {
    if (setbacks[i] > 0 && ++named <= kMost) {
      result += (named == 1 ? "" : ", ") + ("end " + std::to_string(i + 1)) +
                (ends[i].slope == 0 ? " by " : " along its cone by ") + number(setbacks[i]);
    }
  }
  return all > kMost ? result + " and others" : result;
}

std::string of_setbacks(std::span<const Ring> ends, const JunctionOptions& options,
                        const JunctionSearch& refused, const JunctionNeed& takes_wall) {
  const std::string near =
      "end " + std::to_string(*refused.end + 1) + " is too near to the hub's centre";
  const std::string would_do = "it would do to move back ";
  const std::string in_vain = "no ends further back along their axes were found that do";
  const auto least = Setbacks(ends, options, refused.setbacks, {}).run();
  if (!least) {
    return near + ", by at least " + number(refused.setbacks[*refused.end]) + "; " + in_vain;
  }
  // A little further, ends of cones may be too thin.
  const auto enough = takes_wall ? Setbacks(ends, options, *least, takes_wall).run() : least;
  return enough ? near + ": " + would_do + list_of(ends, *enough)
                : near + ": with its walls, " + in_vain + "; without, or with thinner ones, " +
                      would_do + list_of(ends, *least);
}

// None where the junction's wall leaves it no bore however smooth it is.
std::optional<double> fitting_smoothness(std::span<const Ring> ends, const JunctionOptions& options,
                                         const JunctionNeed& need) {
  const auto does = [&](double smoothness) {
    return is_enough(ends, search_junction(ends, with_smoothness(options, smoothness)), need);
  };
  if (!does(0)) {
    return std::nullopt;
  }
  double enough = 0, much = options.smoothness;
  while (much - enough > kPart) {
    const double middle = (much + enough) / 2;
    (does(middle) ? enough : much) = middle;
  }
  return enough;
}

}  // namespace

std::string advice(std::span<const Ring> ends, const JunctionOptions& options,
                   const JunctionSearch& refused, const JunctionNeed& takes_wall) {
  if (!refused.setbacks.empty() && refused.end) {
    return of_setbacks(ends, options, refused, takes_wall);
  }
  const auto enough =
      options.smoothness > 0 ? fitting_smoothness(ends, options, takes_wall) : std::nullopt;
  return enough ? refused.reason + "; a smoothness of " + decimal_at_most(*enough) + " would do"
                : refused.reason;
}

Junction advised_junction(std::span<const Ring> ends, const JunctionOptions& options,
                          const JunctionNeed& takes_wall) {
  JunctionSearch search = search_junction(ends, options);
  if (!search.junction) {
    throw Error(Errc::infeasible_blend, advice(ends, options, search, takes_wall), {},
                search.end ? "end " + std::to_string(*search.end + 1) : "");
  }
  return std::move(*search.junction);
}

}  // namespace dupin::junction

namespace dupin {

Junction junction_of(std::span<const Ring> ends, const JunctionOptions& options) {
  return junction::advised_junction(ends, options, {});
}

}  // namespace dupin
