#include "io/gltf/json_fields.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files/excerpt.hpp"
#include "io/files/load_error.hpp"

namespace raycat {

using nlohmann::json;

JsonFields::JsonFields(std::filesystem::path file, std::string place, std::string path,
                       const json& object)
    : file_(std::move(file)), place_(std::move(place)), path_(std::move(path)), object_(&object) {
  if (!object.is_object()) {
    fail(fmt::format("expected an object, but found {}", excerpt(object.dump())));
  }
}

template <int size>
glm::vec<size, double> JsonFields::vector(const json& value, std::string_view key) const {
  if (!value.is_array() || value.size() != size ||
      !std::all_of(value.begin(), value.end(), [](const json& x) { return x.is_number(); })) {
    fail_type(key, fmt::format("{} numbers", size), value);
  }
  glm::vec<size, double> vector;
  for (int c = 0; c < size; ++c) {
    vector[c] = value[static_cast<std::size_t>(c)].get<double>();
  }
  return vector;
}

template <class T>
std::optional<T> JsonFields::scalar(std::string_view key, std::string_view expected,
                                    bool (*is)(const json& value)) {
  const json* value = find(key);
  if (!value) {
    return std::nullopt;
  }
  if (!is(*value)) {
    fail_type(key, expected, *value);
  }
  return value->get<T>();
}

std::optional<bool> JsonFields::boolean(std::string_view key) {
  return scalar<bool>(key, "true or false", [](const json& value) { return value.is_boolean(); });
}

std::optional<double> JsonFields::number(std::string_view key) {
  return scalar<double>(key, "a number", [](const json& value) { return value.is_number(); });
}

std::optional<glm::dvec2> JsonFields::vector2(std::string_view key) {
  const json* value = find(key);
  return value ? std::optional(vector<2>(*value, key)) : std::nullopt;
}

std::optional<glm::dvec3> JsonFields::vector(std::string_view key) {
  const json* value = find(key);
  return value ? std::optional(vector<3>(*value, key)) : std::nullopt;
}

bool is_whole(const json& value) {
  return value.is_number_unsigned() && value.get<std::uint64_t>() < std::uint64_t{1} << 53;
}

std::optional<glm::dvec4> JsonFields::vector4(std::string_view key) {
  const json* value = find(key);
  return value ? std::optional(vector<4>(*value, key)) : std::nullopt;
}

std::optional<glm::dvec3> JsonFields::number_or_vector(std::string_view key) {
  const json* value = find(key);
  if (!value) {
    return std::nullopt;
  }
  if (!value->is_number() && !value->is_array()) {
    fail_type(key, "a number or 3 numbers", *value);
  }
  return value->is_number() ? glm::dvec3(value->get<double>()) : vector<3>(*value, key);
}

std::optional<std::string> JsonFields::string(std::string_view key) {
  return scalar<std::string>(key, "a string", [](const json& value) { return value.is_string(); });
}

std::optional<std::size_t> JsonFields::index(std::string_view key, std::string_view of,
                                             std::size_t size) {
  const json* value = find(key);
  if (!value) {
    return std::nullopt;
  }
  if (!value->is_number_unsigned()) {
    fail_type(key, "an index", *value);
  }
  if (value->get<std::uint64_t>() >= size) {
    fail(fmt::format("{}: there is no {}[{}]; the file has {}", key, of,
                     value->get<std::uint64_t>(), size));
  }
  return value->get<std::size_t>();
}

std::optional<std::uint64_t> JsonFields::whole(std::string_view key) {
  return scalar<std::uint64_t>(key, "a whole number from 0", is_whole);
}

std::vector<std::pair<std::string, std::uint64_t>> JsonFields::whole_numbers(std::string_view key) {
  std::vector<std::pair<std::string, std::uint64_t>> numbers;
  const json* value = find(key);
  if (!value) {
    return numbers;
  }
  if (!value->is_object()) {
    fail_type(key, "an object", *value);
  }
  for (const auto& [name, number] : value->items()) {
    if (!is_whole(number)) {
      fail_type(fmt::format("{}.{}", key, excerpt(name)), "a whole number from 0", number);
    }
    numbers.emplace_back(name, number.get<std::uint64_t>());
  }
  return numbers;
}

std::optional<std::vector<glm::dvec3>> JsonFields::vectors(std::string_view key) {
  const json* value = find(key);
  if (!value) {
    return std::nullopt;
  }
  if (!value->is_array()) {
    fail_type(key, "an array", *value);
  }
  std::vector<glm::dvec3> vectors;
  vectors.reserve(value->size());
  for (const json& element : *value) {
    vectors.push_back(vector<3>(element, fmt::format("{}[{}]", key, vectors.size())));
  }
  return vectors;
}

std::optional<std::vector<std::vector<std::uint32_t>>> JsonFields::index_lists(
    std::string_view key) {
  const json* value = find(key);
  if (!value) {
    return std::nullopt;
  }
  const auto is_index = [](const json& number) {
    return number.is_number_unsigned() &&
           number.get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max();
  };
  if (!value->is_array()) {
    fail_type(key, "an array", *value);
  }
  std::vector<std::vector<std::uint32_t>> lists;
  lists.reserve(value->size());
  for (const json& list : *value) {
    if (!list.is_array() || !std::all_of(list.begin(), list.end(), is_index)) {
      fail_type(fmt::format("{}[{}]", key, lists.size()), "a list of indices", list);
    }
    lists.push_back(list.get<std::vector<std::uint32_t>>());
  }
  return lists;
}

std::optional<JsonFields> JsonFields::object(std::string_view key) {
  const json* value = find(key);
  if (!value) {
    return std::nullopt;
  }
  return JsonFields(file_, place_,
                    path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key), *value);
}

const nlohmann::json* JsonFields::array(std::string_view key) {
  const json* value = find(key);
  if (value != nullptr && !value->is_array()) {
    fail_type(key, "an array", *value);
  }
  return value;
}

std::string JsonFields::type() {
  const auto type = object_->find("type");
  if (type == object_->end()) {
    fail("type is missing");
  }
  if (!type->is_string()) {
    fail_type("type", "a string", *type);
  }
  typed_ = true;
  return type->get<std::string>();
}

void JsonFields::refuse_others() const {
  for (const auto& [key, value] : object_->items()) {
    if (!(typed_ && key == "type") && std::ranges::find(asked_, key) == asked_.end()) {
      fail(fmt::format("unknown key '{}'; expected {}", excerpt(key),
                       asked_.empty() ? "none" : fmt::format("{}", fmt::join(asked_, ", "))));
    }
  }
}

void JsonFields::fail(const std::string& what) const {
  throw LoadError(file_, place_, path_.empty() ? what : path_ + ": " + what);
}

const json* JsonFields::find(std::string_view key) {
  asked_.emplace_back(key);
  const auto member = object_->find(key);
  return member == object_->end() ? nullptr : &*member;
}

void JsonFields::fail_type(std::string_view key, std::string_view expected,
                           const json& value) const {
  fail(fmt::format("{}: expected {}, but found {}", key, expected, excerpt(value.dump())));
}

}  // namespace raycat
