#include "dynamic/shared_library.hpp"

#include <catch2/catch.hpp>

namespace raycat {
namespace {

TEST_CASE("a function of a library is called by its type", "[dynamic]") {
  const SharedLibrary mathematics("libm.so.6");
  double (*const whole)(double) = mathematics["floor"];
  CHECK(whole(2.5) == 2.0);
}

TEST_CASE("a library that is missing is named, and so is a function", "[dynamic]") {
  CHECK_THROWS_WITH(SharedLibrary("libnone.so.3"),
                    Catch::StartsWith("a library is missing: libnone.so.3: "));
  CHECK_THROWS_WITH(SharedLibrary("libm.so.6")["no_function"],
                    "the library libm.so.6 has no no_function");
}

}  // namespace
}  // namespace raycat
