#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

namespace raycat {

/// Is it a whole number from 0 that JSON's other readers also keep exactly?
bool is_whole(const nlohmann::json& value);

/// One JSON object inside a scene file, read key by key. Everything throws `LoadError`, whose
/// message names the path of what is wrong: `extras.shape: radius: expected a number, ...`. What
/// is absent is `std::nullopt`.
class JsonFields {
 public:
  /// `path` leads to `object` from `place`. The object must outlive this.
  JsonFields(std::filesystem::path file, std::string place, std::string path,
             const nlohmann::json& object);

  std::optional<bool> boolean(std::string_view key);
  std::optional<double> number(std::string_view key);
  std::optional<glm::dvec2> vector2(std::string_view key);
  std::optional<glm::dvec3> vector(std::string_view key);
  std::optional<glm::dvec4> vector4(std::string_view key);
  std::optional<glm::dvec3> number_or_vector(std::string_view key);  ///< 0.5 is (0.5, 0.5, 0.5)
  std::optional<std::string> string(std::string_view key);
  std::optional<std::size_t> index(std::string_view key, std::string_view of, std::size_t size);
  std::optional<std::uint64_t> whole(std::string_view key);  ///< from 0, below 2^53
  std::optional<std::vector<glm::dvec3>> vectors(std::string_view key);
  std::optional<std::vector<std::vector<std::uint32_t>>> index_lists(std::string_view key);
  /// An object's members, all whole numbers; none if it is absent.
  std::vector<std::pair<std::string, std::uint64_t>> whole_numbers(std::string_view key);
  std::optional<JsonFields> object(std::string_view key);
  const nlohmann::json* array(std::string_view key);  ///< null if it is absent

  /// The string `type`, which must be there. Messages do not list it among the expected keys.
  std::string type();

  /// Refuses all keys but those that were asked for.
  void refuse_others() const;

  [[noreturn]] void fail(const std::string& what) const;

 private:
  const nlohmann::json* find(std::string_view key);
  template <class T>
  std::optional<T> scalar(std::string_view key, std::string_view expected,
                          bool (*is)(const nlohmann::json& value));
  template <int size>
  glm::vec<size, double> vector(const nlohmann::json& value, std::string_view key) const;
  [[noreturn]] void fail_type(std::string_view key, std::string_view expected,
                              const nlohmann::json& value) const;

  std::filesystem::path file_;
  std::string place_;
  std::string path_;
  const nlohmann::json* object_;
  std::vector<std::string> asked_;
  bool typed_ = false;
};

}  // namespace raycat
