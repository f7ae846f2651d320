#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace dupin::text {

using Colour = std::array<std::uint8_t, 3>;  // sRGB

/// A colour to tell labels apart: hues a golden section of the circle apart, so that neighbours
/// differ and none returns.
inline Colour label_colour(std::size_t label) {
  constexpr double kGoldenSection = 0.6180339887498949;
  const double turns = std::fmod(0.58 + kGoldenSection * static_cast<double>(label), 1.0);
  Colour colour{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    // A trapezoid wave over the hue circle, shifted by a third for each channel, in light tones.
    const double phase = std::fmod(6 * turns + 8 - 2 * static_cast<double>(channel), 6.0);
    const double wave = std::fmin(std::fmax(std::abs(phase - 3) - 1, 0.0), 1.0);
    colour[channel] = static_cast<std::uint8_t>(std::lround(120 + 120 * wave));
  }
  return colour;
}

/// "#RRGGBB"
inline std::string colour_code(const Colour& colour) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string code = "#";
  for (const std::uint8_t channel : colour) {
    code += kDigits[channel >> 4];
    code += kDigits[channel & 15];
  }
  return code;
}

}  // namespace dupin::text
