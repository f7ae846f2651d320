#include "pcf/nominal_pipe.h"

#include <array>
#include <cmath>

namespace dupin::pcf {
namespace {

// Tables differ by this much in how they round inches: 273 and 273.05, 323.8 and 323.9.
constexpr double kTableRounding = 0.2;
// Files write names to three or four decimals.
constexpr double kNameRounding = 1e-3;
constexpr double kInch = 25.4;

constexpr std::array kPipes = std::to_array<NominalPipe>(
    {{0.125, 6, 10.3}, {0.25, 8, 13.7},  {0.375, 10, 17.1}, {0.5, 15, 21.3},  {0.75, 20, 26.7},
     {1, 25, 33.4},    {1.25, 32, 42.2}, {1.5, 40, 48.3},   {2, 50, 60.3},    {2.5, 65, 73.0},
     {3, 80, 88.9},    {3.5, 90, 101.6}, {4, 100, 114.3},   {5, 125, 141.3},  {6, 150, 168.3},
     {8, 200, 219.1},  {10, 250, 273.0}, {12, 300, 323.8},  {14, 350, 355.6}, {16, 400, 406.4},
     {18, 450, 457},   {20, 500, 508},   {22, 550, 559},    {24, 600, 610},   {26, 650, 660},
     {28, 700, 711},   {30, 750, 762},   {32, 800, 813},    {34, 850, 864},   {36, 900, 914},
     {38, 950, 965},   {40, 1000, 1016}, {42, 1050, 1067},  {44, 1100, 1118}, {46, 1150, 1168},
     {48, 1200, 1219}});

}  // namespace

std::span<const NominalPipe> nominal_pipes() { return kPipes; }

const NominalPipe* called(double bore, BoreUnit unit) {
  for (const NominalPipe& pipe : kPipes) {
    const bool is_inches = unit == BoreUnit::inch
                               ? std::abs(bore - pipe.inches) <= kNameRounding
                               : std::abs(bore - pipe.inches * kInch) <= kNameRounding;
    if (is_inches || (unit == BoreUnit::millimetre && bore == pipe.nominal)) {
      return &pipe;
    }
  }
  return nullptr;
}

const NominalPipe* of_outside(double diameter) {
  for (const NominalPipe& pipe : kPipes) {
    if (std::abs(diameter - pipe.outside) <= kTableRounding) {
      return &pipe;
    }
  }
  return nullptr;
}

}  // namespace dupin::pcf
