#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

namespace raycat {

/// What is in an EXR file, read by OpenEXR.
class ExrValues {
 public:
  explicit ExrValues(const std::filesystem::path& path) : file_(path.c_str()) {}

  std::vector<std::string> channels() const {
    std::vector<std::string> names;
    const Imf::ChannelList& all = file_.header().channels();
    for (auto it = all.begin(); it != all.end(); ++it) {
      names.emplace_back(it.name());
    }
    return names;
  }

  Imf::PixelType type(const char* channel) const { return file_.header().channels()[channel].type; }

  std::string text(const char* attribute) const {
    return file_.header().typedAttribute<Imf::StringAttribute>(attribute).value();
  }

  /// Rows from the top, of the type that the file has.
  template <typename Value>
  std::vector<Value> values(const char* channel) {
    const Imath::Box2i window = file_.header().dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x + 1);
    std::vector<Value> values(width * static_cast<std::size_t>(window.max.y + 1));
    Imf::FrameBuffer pixels;
    pixels.insert(channel, Imf::Slice(type(channel), reinterpret_cast<char*>(values.data()),
                                      sizeof(Value), sizeof(Value) * width));
    file_.setFrameBuffer(pixels);
    file_.readPixels(0, window.max.y);
    return values;
  }

 private:
  Imf::InputFile file_;
};

}  // namespace raycat
