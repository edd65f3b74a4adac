#include "categories/encoder.hpp"

#include <stdexcept>

namespace raycat {

std::string_view name(Method method) {
  constexpr std::string_view names[] = {"heap", "string", "primes", "godel"};
  return names[static_cast<int>(method)];
}

Encoder make_encoder(Method method, const Extent& scene) {
  switch (method) {
    case Method::string:
      return IdString(scene);
    case Method::primes:
      return PrimesProduct(scene);
    case Method::godel:
      return GodelNumber(scene);
    case Method::heap:
      break;
  }
  if (within(scene, PackedHeap::limits)) {
    return PackedHeap(scene);
  }
  return WideHeap(scene);
}

void encode(const Encoder& encoder, std::span<const RayNode> tree, CategoryWords& words) {
  std::visit([&](const auto& method) { method.encode(tree, words); }, encoder);
}

bool overflowed(const Encoder& encoder, std::span<const std::uint32_t> words) {
  if (std::holds_alternative<PrimesProduct>(encoder)) {
    return PrimesProduct::overflowed(words);
  }
  return std::holds_alternative<GodelNumber>(encoder) && GodelNumber::overflows(words, 64);
}

void decode(const Encoder& encoder, std::span<const std::uint32_t> words, RayTree& tree) {
  if (std::holds_alternative<PackedHeap>(encoder)) {
    PackedHeap::decode(words, tree);
  } else if (std::holds_alternative<WideHeap>(encoder)) {
    WideHeap::decode(words, tree);
  } else {
    throw std::logic_error("only heap categories can be read back as trees");
  }
}

}  // namespace raycat
