#include "BigEndian.h"
#include "Crc64.h"
#include "LinkTime.h"

#include <insonate/igtlink/LinkMessage.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace insonate {
namespace {

constexpr std::size_t kTransformSize = 48, kTrackingSize = 70, kQuaternionTrackingSize = 50, kToolNameSize = 20;
constexpr std::uint16_t kUsAscii = 3;  // MIBenum of US-ASCII, the default of STRING

/// Appends the header, then the content that `write` writes, and completes size and CRC.
template <class Write>
void appendMessage(std::vector<std::uint8_t>& bytes, std::string_view type, std::string_view device,
                   std::int64_t time_ns, const Write& write) {
  const std::size_t begin = bytes.size();
  BigEndianWriter writer(bytes);
  writer.integer(std::uint16_t{1});
  writer.text(type, kLinkTypeSize);
  writer.text(device, kLinkDeviceSize);
  writer.integer(linkTimestamp(time_ns));
  const std::size_t sizes = bytes.size();
  writer.integer(std::uint64_t{0}), writer.integer(std::uint64_t{0});
  write(writer);
  const std::span<const std::uint8_t> content = std::span<const std::uint8_t>(bytes).subspan(begin + kLinkHeaderSize);
  std::vector<std::uint8_t> numbers;
  BigEndianWriter numbersWriter(numbers);
  numbersWriter.integer(std::uint64_t{content.size()});
  numbersWriter.integer(crc64(content));
  std::ranges::copy(numbers, bytes.begin() + static_cast<std::ptrdiff_t>(sizes));
}

void writeVector(BigEndianWriter& writer, Vec3 v) {
  writer.real(v.x), writer.real(v.y), writer.real(v.z);
}

Vec3 readVector(BigEndianReader& reader) {
  Vec3 v;
  v.x = reader.real(), v.y = reader.real(), v.z = reader.real();
  return v;
}

/// The rotation nearest to `m` in a few steps of Newton's iteration for the polar decomposition; none if `m` is not a
/// rotation within 1 %.
std::optional<Mat3> nearestRotation(Mat3 m) {
  constexpr double kTolerance = 0.01;
  for (int axis = 0; axis < 3; ++axis) {
    if (!isFinite(m.column[axis]) || std::abs(norm(m.column[axis]) - 1) > kTolerance) return std::nullopt;
    if (std::abs(dot(m.column[axis], m.column[(axis + 1) % 3])) > kTolerance) return std::nullopt;
  }
  if (determinant(m) < 0) return std::nullopt;
  for (int step = 0; step < 4; ++step) {
    const Mat3 other = transposed(inverted(m));
    for (int axis = 0; axis < 3; ++axis) m.column[axis] = 0.5 * (m.column[axis] + other.column[axis]);
  }
  return m;
}

void addPose(std::vector<LinkPose>& poses, std::string name, const Mat3& linear, Vec3 offset) {
  const auto rotation = nearestRotation(linear);
  if (rotation && isFinite(offset)) poses.push_back({std::move(name), {*rotation, offset}});
}

void addMatrix(std::vector<LinkPose>& poses, std::string name, BigEndianReader& reader) {
  Mat3 linear;
  for (Vec3& column : linear.column) column = readVector(reader);
  const Vec3 offset = readVector(reader);
  addPose(poses, std::move(name), linear, offset);
}

Mat3 rotationOf(const std::array<double, 4>& q) {
  const auto [x, y, z, w] = q;
  return {{Vec3{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
           Vec3{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
           Vec3{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}};
}

/// Reads position and quaternion, whose last component is left out in the short form of POSITION.
void addQuaternion(std::vector<LinkPose>& poses, std::string name, BigEndianReader& reader, bool hasLast) {
  const Vec3 offset = readVector(reader);
  std::array<double, 4> q{};
  for (std::size_t i = 0; i < (hasLast ? 4U : 3U); ++i) q[i] = reader.real();
  double squares = 0;
  for (const double part : q) squares += part * part;
  if (!hasLast) {
    q[3] = std::sqrt(std::max(0.0, 1 - squares));
    squares = std::max(1.0, squares);
  }
  if (!std::isfinite(squares) || std::abs(squares - 1) > 0.02) return;
  for (double& part : q) part /= std::sqrt(squares);
  addPose(poses, std::move(name), rotationOf(q), offset);
}

}  // namespace

void appendTransform(std::vector<std::uint8_t>& bytes, const LinkTransform& transform, std::int64_t time_ns) {
  appendMessage(bytes, "TRANSFORM", transform.name, time_ns, [&](BigEndianWriter& writer) {
    for (const Vec3& column : transform.targetFromSource.linear.column) writeVector(writer, column);
    writeVector(writer, transform.targetFromSource.offset);
  });
}

void appendImage(std::vector<std::uint8_t>& bytes, const LinkImage& image, std::int64_t time_ns) {
  constexpr int kMaxSize = std::numeric_limits<std::uint16_t>::max();
  if (!image.gray || image.width < 1 || image.height < 1 || image.width > kMaxSize || image.height > kMaxSize) return;
  if (image.gray->size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) return;
  const Transform& place = image.referenceFromPixel;
  const Vec3 middle = place * Vec3{(image.width - 1) / 2.0, (image.height - 1) / 2.0, 0};
  const auto columns = static_cast<std::uint16_t>(image.width), rows = static_cast<std::uint16_t>(image.height);
  bytes.reserve(bytes.size() + kLinkHeaderSize + 72 + image.gray->size());
  appendMessage(bytes, "IMAGE", image.name, time_ns, [&](BigEndianWriter& writer) {
    writer.integer(std::uint16_t{1});  // version of the format of IMAGE
    // One component; unsigned 8-bit; big-endian; RAS.
    writer.integer(std::uint32_t{0x01'03'01'01});
    const auto size = [&] { writer.integer(columns), writer.integer(rows), writer.integer(std::uint16_t{1}); };
    size();
    for (const Vec3& column : place.linear.column) writeVector(writer, column);
    writeVector(writer, middle);
    for (int axis = 0; axis < 3; ++axis) writer.integer(std::uint16_t{0});
    size();
    writer.raw(*image.gray);
  });
}

void appendString(std::vector<std::uint8_t>& bytes, std::string_view device, std::string_view text,
                  std::int64_t time_ns) {
  text = text.substr(0, std::numeric_limits<std::uint16_t>::max());
  appendMessage(bytes, "STRING", device, time_ns, [&](BigEndianWriter& writer) {
    writer.integer(kUsAscii);
    writer.integer(static_cast<std::uint16_t>(text.size()));
    writer.text(text, text.size());
  });
}

void appendTrackingRequest(std::vector<std::uint8_t>& bytes, int resolution_ms) {
  appendMessage(bytes, "STT_TDATA", "Insonate", 0, [&](BigEndianWriter& writer) {
    writer.integer(static_cast<std::uint32_t>(resolution_ms));
    writer.text("Reference", 32);
  });
}

std::vector<LinkPose> posesOf(const LinkMessage& message) {
  std::vector<LinkPose> poses;
  const std::size_t size = message.content.size();
  BigEndianReader reader(message.content);
  if (message.type == "TRANSFORM" && size == kTransformSize) {
    addMatrix(poses, message.device, reader);
  } else if (message.type == "POSITION" && (size == 24 || size == 28)) {
    addQuaternion(poses, message.device, reader, size == 28);
  } else if ((message.type == "TDATA" && size % kTrackingSize == 0) ||
             (message.type == "QTDATA" && size % kQuaternionTrackingSize == 0)) {
    while (reader.left() > 0) {
      std::string name = reader.text(kToolNameSize);
      reader.take(2);  // kind of the instrument, reserved
      if (message.type == "TDATA")
        addMatrix(poses, std::move(name), reader);
      else
        addQuaternion(poses, std::move(name), reader, true);
    }
  }
  return poses;
}

std::optional<std::string> textOf(const LinkMessage& message) {
  if (message.type != "STRING") return std::nullopt;
  BigEndianReader reader(message.content);
  reader.take(2);  // encoding: any that contains US-ASCII
  const auto text = reader.take(reader.integer<std::uint16_t>());
  if (reader.isPastEnd()) return std::nullopt;
  return std::string(text.begin(), text.end());
}

}  // namespace insonate
