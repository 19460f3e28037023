#pragma once

#include <insonate/core/Transform.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Size of the header at the beginning of each message of OpenIGTLink, and of its texts, in bytes.
inline constexpr std::size_t kLinkHeaderSize = 58, kLinkTypeSize = 12, kLinkDeviceSize = 20;

/// A message that was received: fields of the header, and the content without extended header and metadata.
struct LinkMessage {
  int version = 1;           ///< version of the header: 1, or 2 if the message had an extended header
  std::string type, device;  ///< data type, e.g. "TRANSFORM", and device name, e.g. "ProbeToReference"
  /// time that the sender stated, ns since the beginning of 1970 by the sender's clock; 0: not stated
  std::int64_t time_ns = 0;
  std::vector<std::uint8_t> content;
};

/// An 8-bit image of one slice with its place.
struct LinkImage {
  std::string name;              ///< device name of the message
  int width = 0, height = 0;     ///< size in pixels, 1 to 65535
  Transform referenceFromPixel;  ///< maps (column, row, 0) to the pixel's center, mm; Reference is in RAS directions
  std::shared_ptr<const std::vector<std::uint8_t>> gray;  ///< gray values, index [row][column]
};

/// A transform with the name of its message.
struct LinkTransform {
  std::string name;
  Transform targetFromSource;
};

/// Pose of one tool in a message TRANSFORM, TDATA, QTDATA or POSITION.
struct LinkPose {
  std::string name;  ///< device name of the message; TDATA and QTDATA: name of the tool
  Transform trackerFromTool;
};

/// Append a message with a header of version 1 to `bytes`. Names longer than 20 bytes are cut. `time_ns`: ns since the
/// beginning of 1970.
void appendTransform(std::vector<std::uint8_t>& bytes, const LinkTransform& transform, std::int64_t time_ns);
/// Appends an IMAGE message. Its matrix has the position of the middle of the image, as 3D Slicer and the library of
/// OpenIGTLink expect. Appends nothing if size and gray values do not match.
void appendImage(std::vector<std::uint8_t>& bytes, const LinkImage& image, std::int64_t time_ns);
/// Appends a STRING message. A text of more than 65535 bytes is cut.
void appendString(std::vector<std::uint8_t>& bytes, std::string_view device, std::string_view text,
                  std::int64_t time_ns);
/// Appends the request STT_TDATA, by which a client asks for TDATA messages, at most one every `resolution_ms`.
void appendTrackingRequest(std::vector<std::uint8_t>& bytes, int resolution_ms);

/// Returns the poses in a message TRANSFORM, TDATA, QTDATA or POSITION. Poses that are not finite and rigid (within 1
/// %) are left out; the others are made rigid. Empty for other types and for content of another length.
std::vector<LinkPose> posesOf(const LinkMessage& message);
/// Returns the text of a STRING message; empty if the content is too short for the text's length.
std::optional<std::string> textOf(const LinkMessage& message);

}  // namespace insonate
