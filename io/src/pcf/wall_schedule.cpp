#include "pcf/wall_schedule.h"

#include <algorithm>
#include <array>

#include "text/lower_case.h"

namespace dupin::pcf {
namespace {

constexpr std::array<std::string_view, 14> kSchedules{
    "5", "10", "20", "30", "STD", "40", "60", "XS", "80", "100", "120", "140", "160", "XXS"};

struct Walls {
  double inches;
  std::array<double, kSchedules.size()> of_schedule;  ///< 0: not made
};

// ASME B36.10M, table 1, in millimetres.
constexpr std::array kWalls = std::to_array<Walls>(
    //            5    10    20    30    STD   40    60     XS    80     100    120    140    160
    //            XXS
    {{0.5, {1.65, 2.11, 0, 2.41, 2.77, 2.77, 0, 3.73, 3.73, 0, 0, 0, 4.78, 7.47}},
     {0.75, {1.65, 2.11, 0, 2.41, 2.87, 2.87, 0, 3.91, 3.91, 0, 0, 0, 5.56, 7.82}},
     {1, {1.65, 2.77, 0, 2.90, 3.38, 3.38, 0, 4.55, 4.55, 0, 0, 0, 6.35, 9.09}},
     {1.25, {1.65, 2.77, 0, 2.97, 3.56, 3.56, 0, 4.85, 4.85, 0, 0, 0, 6.35, 9.70}},
     {1.5, {1.65, 2.77, 0, 3.18, 3.68, 3.68, 0, 5.08, 5.08, 0, 0, 0, 7.14, 10.15}},
     {2, {1.65, 2.77, 0, 3.18, 3.91, 3.91, 0, 5.54, 5.54, 0, 0, 0, 8.74, 11.07}},
     {2.5, {2.11, 3.05, 0, 4.78, 5.16, 5.16, 0, 7.01, 7.01, 0, 0, 0, 9.53, 14.02}},
     {3, {2.11, 3.05, 0, 4.78, 5.49, 5.49, 0, 7.62, 7.62, 0, 0, 0, 11.13, 15.24}},
     {3.5, {2.11, 3.05, 0, 4.78, 5.74, 5.74, 0, 8.08, 8.08, 0, 0, 0, 0, 0}},
     {4, {2.11, 3.05, 0, 4.78, 6.02, 6.02, 0, 8.56, 8.56, 0, 11.13, 0, 13.49, 17.12}},
     {5, {2.77, 3.40, 0, 0, 6.55, 6.55, 0, 9.53, 9.53, 0, 12.70, 0, 15.88, 19.05}},
     {6, {2.77, 3.40, 0, 0, 7.11, 7.11, 0, 10.97, 10.97, 0, 14.27, 0, 18.26, 21.95}},
     {8,
      {2.77, 3.76, 6.35, 7.04, 8.18, 8.18, 10.31, 12.70, 12.70, 15.09, 18.26, 20.62, 23.01, 22.23}},
     {10,
      {3.40, 4.19, 6.35, 7.80, 9.27, 9.27, 12.70, 12.70, 15.09, 18.26, 21.44, 25.40, 28.58, 25.40}},
     {12,
      {3.96, 4.57, 6.35, 8.38, 9.53, 10.31, 14.27, 12.70, 17.48, 21.44, 25.40, 28.58, 33.32,
       25.40}},
     {14,
      {3.96, 6.35, 7.92, 9.53, 9.53, 11.13, 15.09, 12.70, 19.05, 23.83, 27.79, 31.75, 35.71, 0}},
     {16,
      {4.19, 6.35, 7.92, 9.53, 9.53, 12.70, 16.66, 12.70, 21.44, 26.19, 30.96, 36.53, 40.49, 0}},
     {18,
      {4.19, 6.35, 7.92, 11.13, 9.53, 14.27, 19.05, 12.70, 23.83, 29.36, 34.93, 39.67, 45.24, 0}},
     {20,
      {4.78, 6.35, 9.53, 12.70, 9.53, 15.09, 20.62, 12.70, 26.19, 32.54, 38.10, 44.45, 50.01, 0}},
     {22, {4.78, 6.35, 9.53, 12.70, 9.53, 0, 22.23, 12.70, 28.58, 34.93, 41.28, 47.63, 53.98, 0}},
     {24,
      {5.54, 6.35, 9.53, 14.27, 9.53, 17.48, 24.61, 12.70, 30.96, 38.89, 46.02, 52.37, 59.54, 0}}});

std::size_t position(std::string_view name) {
  const auto found =
      std::ranges::find(kSchedules, text::lower_case(std::string(name)),
                        [](std::string_view own) { return text::lower_case(std::string(own)); });
  return static_cast<std::size_t>(found - kSchedules.begin());
}

template <class Chosen>
std::string joined(const Chosen& is_chosen) {
  std::string names;
  for (const std::string_view name : kSchedules) {
    if (is_chosen(name)) {
      names.append(names.empty() ? "" : ", ").append(name);
    }
  }
  return names;
}

}  // namespace

std::string schedule_names() {
  return joined([](std::string_view) { return true; });
}

std::string schedule_names(const NominalPipe& pipe) {
  return joined([&](std::string_view name) { return wall_of(pipe, name).has_value(); });
}

bool is_schedule(std::string_view name) { return position(name) < kSchedules.size(); }

std::optional<double> wall_of(const NominalPipe& pipe, std::string_view schedule) {
  const auto walls = std::ranges::find(kWalls, pipe.inches, &Walls::inches);
  if (walls == kWalls.end() || !is_schedule(schedule)) {
    return std::nullopt;
  }
  const double wall = walls->of_schedule.at(position(schedule));
  return wall > 0 ? std::optional(wall) : std::nullopt;
}

}  // namespace dupin::pcf
