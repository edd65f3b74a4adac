#include "io/images/exr_file.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <utility>

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

namespace raycat {
namespace {

// A file in memory. OpenEXR comes back to where it left room for what it learns last.
class MemoryFile : public Imf::OStream {
 public:
  MemoryFile() : OStream("memory") {}

  void write(const char* data, int count) override {
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    const std::size_t end = at_ + static_cast<std::size_t>(count);
    if (end > bytes_.size()) {
      bytes_.resize(end);
    }
    std::copy_n(bytes, count, bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ = end;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t at) override { at_ = at; }

  std::vector<std::byte>& bytes() { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
  std::uint64_t at_ = 0;
};

}  // namespace

std::vector<std::byte> exr_file(int width, int height, std::span<const ExrChannel> channels,
                                const Provenance& provenance) try {
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [keyword, text] : provenance_texts(provenance, "comments")) {
    header.insert(keyword, Imf::StringAttribute(text));
  }
  Imf::FrameBuffer pixels;
  for (const ExrChannel& channel : channels) {
    const Imf::PixelType type = channel.whole ? Imf::UINT : Imf::FLOAT;
    header.channels().insert(channel.name, Imf::Channel(type));
    // OpenEXR reads them alone, but asks for what it could write.
    char* const first = const_cast<char*>(static_cast<const char*>(channel.first));
    pixels.insert(channel.name, Imf::Slice(type, first, channel.stride,
                                           channel.stride * static_cast<std::size_t>(width)));
  }
  // OpenEXR packs on threads of its own, which it starts once. The file is written by this one.
  const int threads = static_cast<int>(std::thread::hardware_concurrency());
  if (Imf::globalThreadCount() < threads) {
    Imf::setGlobalThreadCount(threads);
  }
  MemoryFile file;
  {
    Imf::OutputFile out(file, header, threads);
    out.setFrameBuffer(pixels);
    out.writePixels(height);
  }  // which ends the file
  return std::move(file.bytes());
} catch (const Iex::BaseExc& error) {
  throw std::runtime_error(error.what());
}

}  // namespace raycat
