#pragma once

#include <array>
#include <cstdio>

#include <png.h>

namespace raycat {

/// libpng reports errors by jumping back to where it was called from, past destructors. So nothing
/// that has one lives on the way: callbacks keep what they must in a struct that outlives the jump,
/// and the functions that call libpng are handed all they need.
struct PngError {
  std::array<char, 200> text{};
};

/// Libpng's handler of errors: keeps the message in the `PngError` that the file was made with, and
/// jumps. Nothing is printed.
[[noreturn]] inline void keep_png_error(png_structp png, png_const_charp message) {
  auto& text = static_cast<PngError*>(png_get_error_ptr(png))->text;
  std::snprintf(text.data(), text.size(), "%s", message);
  png_longjmp(png, 1);
}

}  // namespace raycat
