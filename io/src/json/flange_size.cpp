#include "json/flange_size.h"

#include <algorithm>
#include <array>

namespace dupin::json {
namespace {

// ASME B16.5, tables of dimensions of class 150 and class 300 flanges: outside diameter and least
// thickness.
constexpr auto kClass150 = std::to_array<FlangeSize>(
    {{0.5, 90, 9.6},  {0.75, 100, 11.2}, {1, 110, 12.7},  {1.25, 115, 14.3}, {1.5, 125, 15.9},
     {2, 150, 17.5},  {2.5, 180, 20.7},  {3, 190, 22.3},  {3.5, 215, 22.3},  {4, 230, 22.3},
     {5, 255, 22.3},  {6, 280, 23.9},    {8, 345, 27},    {10, 405, 28.6},   {12, 485, 30.2},
     {14, 535, 33.4}, {16, 595, 35},     {18, 635, 38.1}, {20, 700, 41.3},   {24, 815, 46.1}});
constexpr auto kClass300 = std::to_array<FlangeSize>(
    {{0.5, 95, 12.7}, {0.75, 115, 14.3}, {1, 125, 15.9},  {1.25, 135, 17.5}, {1.5, 155, 19.1},
     {2, 165, 20.7},  {2.5, 190, 23.9},  {3, 210, 27},    {3.5, 230, 28.6},  {4, 255, 30.2},
     {5, 280, 33.4},  {6, 320, 35},      {8, 380, 39.7},  {10, 445, 46.1},   {12, 520, 49.3},
     {14, 585, 52.4}, {16, 650, 55.6},   {18, 710, 58.8}, {20, 775, 62},     {24, 915, 68.3}});

}  // namespace

std::optional<FlangeSize> flange_of(double inches, std::string_view pressure_class) {
  if (pressure_class != "150" && pressure_class != "300") {
    return std::nullopt;
  }
  const auto& table = pressure_class == "150" ? kClass150 : kClass300;
  const auto found = std::ranges::find(table, inches, &FlangeSize::inches);
  return found == table.end() ? std::nullopt : std::optional(*found);
}

}  // namespace dupin::json
