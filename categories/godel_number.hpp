#pragma once

#include <span>

#include "categories/id_string.hpp"

namespace raycat {

/// Gödel numbering (Section 2.1.3): the string a_1 a_2 ... a_n of symbols is the number
/// p_1^a_1 p_2^a_2 ... p_n^a_n of the first n primes. The number is kept in factored form, exact at
/// any size: its words are the exponents, so equal words are equal numbers and equal strings.
/// `godel_number` in exact_number.hpp multiplies it out.
class GodelNumber {
 public:
  static constexpr Extent limits = IdString::limits;

  /// Throws `std::length_error`, naming the count, if `scene` is past `limits`.
  explicit GodelNumber(const Extent& scene);

  /// Sets `words` to the exponents of the first primes.
  void encode(std::span<const RayNode> tree, CategoryWords& words) const {
    string_.encode(tree, words);
  }

  /// Does the number with these exponents, all positive, need more than `bits` bits?
  static bool overflows(std::span<const std::uint32_t> exponents, std::size_t bits);

 private:
  IdString string_;
};

}  // namespace raycat
