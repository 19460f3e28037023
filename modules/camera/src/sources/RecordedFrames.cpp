#include "sources/PixelFormats.h"

#include <insonate/camera/CameraSource.h>
#include <insonate/core/AtomicFile.h>

#include <png.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <optional>
#include <vector>

namespace insonate {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSide = 8192;
constexpr std::int64_t kFrame_ns = 33'333'333;

std::string lowerExtension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

Result<void> readPgm(const fs::path& file, CameraFrame& frame) {
  std::ifstream in(file, std::ios::binary);
  const auto damaged = [&] { return fail(file.string() + ": is no binary PGM image with 8 bits. Export it again."); };
  if (!in) return fail(file.string() + ": cannot be opened. Check its permissions.");
  std::string magic;
  int width = 0, height = 0, most = 0;
  const auto number = [&](int& value) {
    while (in >> std::ws && in.peek() == '#') in.ignore(4096, '\n');
    in >> value;
  };
  in >> magic;
  number(width), number(height), number(most);
  in.get();
  if (!in || magic != "P5" || width < 1 || height < 1 || width > kMaxSide || height > kMaxSide || most < 1 ||
      most > 255)
    return damaged();
  frame.width = width, frame.height = height;
  frame.pixels.resize(std::size_t(width) * std::size_t(height));
  in.read(reinterpret_cast<char*>(frame.pixels.data()), std::streamsize(frame.pixels.size()));
  if (!in) return damaged();
  return {};
}

Result<void> readPng(const fs::path& file, CameraFrame& frame) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const auto failed = [&]() -> Result<void> {
    const std::string reason = image.message;
    png_image_free(&image);
    return fail(file.string() + ": cannot be read as PNG (" + reason + "). Export it again.");
  };
  if (!png_image_begin_read_from_file(&image, file.c_str())) return failed();
  if (image.width > unsigned(kMaxSide) || image.height > unsigned(kMaxSide)) {
    png_image_free(&image);
    return fail(file.string() + ": is larger than 8192 pixels. Scale it down.");
  }
  image.format = PNG_FORMAT_GRAY;
  frame.width = int(image.width), frame.height = int(image.height);
  frame.pixels.resize(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, frame.pixels.data(), 0, nullptr)) return failed();
  return {};
}

Result<void> readImage(const fs::path& file, CameraFrame& frame) {
  return lowerExtension(file) == ".png" ? readPng(file, frame) : readPgm(file, frame);
}

class FrameFolder : public CameraSource {
 public:
  FrameFolder(fs::path folder, std::vector<fs::path> files, int width, int height)
      : folder_(std::move(folder)), files_(std::move(files)), width_(width), height_(height) {}
  std::string name() const override { return folder_.string(); }
  int width() const override { return width_; }
  int height() const override { return height_; }
  Result<CameraStatus> next(CameraFrame& frame, std::chrono::milliseconds) override {
    if (next_ >= files_.size()) return CameraStatus::kEnded;
    const fs::path& file = files_[next_++];
    if (auto ok = readImage(file, frame); !ok) return tl::unexpected(ok.error());
    if (frame.width != width_ || frame.height != height_)
      return fail(file.string() + ": has another size than the first frame. Remove it from the folder.");
    frame.time_ns = std::int64_t(next_) * kFrame_ns, frame.exposure_ns = 0;
    return CameraStatus::kFrame;
  }

 private:
  fs::path folder_;
  std::vector<fs::path> files_;
  int width_, height_;
  std::size_t next_ = 0;
};

class RawFile : public CameraSource {
 public:
  RawFile(fs::path file, int width, int height, int bytesPerPixel)
      : file_(std::move(file)),
        in_(file_, std::ios::binary),
        width_(width),
        height_(height),
        bytes_(std::size_t(width) * std::size_t(height) * std::size_t(bytesPerPixel)),
        bytesPerPixel_(bytesPerPixel) {}
  bool isOpen() const { return bool(in_); }
  std::string name() const override { return file_.string(); }
  int width() const override { return width_; }
  int height() const override { return height_; }
  Result<CameraStatus> next(CameraFrame& frame, std::chrono::milliseconds) override {
    in_.read(reinterpret_cast<char*>(bytes_.data()), std::streamsize(bytes_.size()));
    if (in_.gcount() == 0) return CameraStatus::kEnded;
    if (std::size_t(in_.gcount()) < bytes_.size())
      return fail(file_.string() +
                  ": ends within a frame. Check the size in the name of the file, and record it again.");
    const std::size_t stride = std::size_t(width_) * std::size_t(bytesPerPixel_);
    if (bytesPerPixel_ == 2)
      camera::grayFromYuyv(bytes_, width_, height_, stride, frame.pixels);
    else
      camera::grayFromGray(bytes_, width_, height_, stride, frame.pixels);
    frame.width = width_, frame.height = height_;
    frame.time_ns = ++count_ * kFrame_ns, frame.exposure_ns = 0;
    return CameraStatus::kFrame;
  }

 private:
  fs::path file_;
  std::ifstream in_;
  int width_, height_;
  std::vector<std::uint8_t> bytes_;
  int bytesPerPixel_;
  std::int64_t count_ = 0;
};

Result<std::unique_ptr<CameraSource>> openFolder(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string extension = lowerExtension(entry->path());
    if (extension == ".pgm" || extension == ".png") files.push_back(entry->path());
  }
  if (error) return fail(folder.string() + ": cannot be read. Check its permissions.");
  if (files.empty())
    return fail(folder.string() + ": contains no PGM or PNG files. Name a folder with frames of a camera.");
  std::sort(files.begin(), files.end());
  CameraFrame first;
  if (auto ok = readImage(files.front(), first); !ok) return tl::unexpected(ok.error());
  return std::make_unique<FrameFolder>(folder, std::move(files), first.width, first.height);
}

/// Reads width and height from the end of a name such as hands_1280x720; false if there is no size.
bool readSize(const std::string& stem, int& width, int& height) {
  const std::size_t from = stem.rfind('_');
  if (from == std::string::npos) return false;
  const char* const end = stem.data() + stem.size();
  const auto [x, wrongWidth] = std::from_chars(stem.data() + from + 1, end, width);
  if (wrongWidth != std::errc() || x == end || *x != 'x') return false;
  const auto [rest, wrongHeight] = std::from_chars(x + 1, end, height);
  return wrongHeight == std::errc() && rest == end;
}

Result<std::unique_ptr<CameraSource>> openRaw(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  int width = 0, height = 0;
  if ((extension != ".y8" && extension != ".gray" && extension != ".yuyv") ||
      !readSize(file.stem().string(), width, height))
    return fail(file.string() +
                ": the name states no size and format. Rename it, for example to hands_1280x720.y8 or "
                "hands_1280x720.yuyv.");
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
    return fail(file.string() + ": the size in the name is not 1 to 8192 pixels.");
  auto source = std::make_unique<RawFile>(file, width, height, extension == ".yuyv" ? 2 : 1);
  if (!source->isOpen()) return fail(file.string() + ": cannot be opened. Check its permissions.");
  return source;
}

}  // namespace

Result<std::unique_ptr<CameraSource>> openRecordedFrames(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return openFolder(path);
  if (!fs::exists(path, error)) return fail(path.string() + ": does not exist. Name a folder or a file with frames.");
  return openRaw(path);
}

Result<void> writePgm(const CameraFrame& frame, const fs::path& file) {
  std::string bytes = "P5\n" + std::to_string(frame.width) + " " + std::to_string(frame.height) + "\n255\n";
  bytes.append(frame.pixels.begin(), frame.pixels.end());
  return writeAtomically(file, bytes);
}

}  // namespace insonate
