#pragma once

#include <cstdint>
#include <span>

#include <boost/multiprecision/cpp_int.hpp>

namespace raycat {

/// An integer of any size.
using BigInteger = boost::multiprecision::cpp_int;

/// The product of `factors`, exact; of none, 1.
BigInteger exact_product(std::span<const std::uint32_t> factors);

/// The Gödel number p_1^a_1 p_2^a_2 ... of these exponents (Section 2.1.3), exact.
BigInteger godel_number(std::span<const std::uint32_t> exponents);

/// About how many bits `godel_number` would have, for numbers that are too long to work out.
double godel_bits(std::span<const std::uint32_t> exponents);

}  // namespace raycat
