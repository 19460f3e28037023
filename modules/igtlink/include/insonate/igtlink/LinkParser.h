#pragma once

#include <insonate/core/Result.h>
#include <insonate/igtlink/LinkMessage.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Numbers of messages since the beginning of a connection.
struct LinkCounters {
  std::uint64_t taken = 0;    ///< messages that were passed on
  std::uint64_t skipped = 0;  ///< messages of other types, and messages above the maximum size
  std::uint64_t damaged = 0;  ///< messages with a wrong CRC, or with an extended header that does not fit
};

/// Splits a stream of bytes into messages. Reads headers of version 1, and of versions 2 and 3, whose extended header
/// and metadata it removes. A message of another type, or a message that is too large, is skipped by its size without
/// being stored. The parser stores at most one message. One object must not be used concurrently.
class LinkParser {
 public:
  using Take = std::function<void(LinkMessage&&)>;
  /// Maximum size of the body of a message that is passed on, bytes.
  static constexpr std::size_t kMaxBody = 256 * 1024;

  /// `types`: the types of the messages that are passed on.
  explicit LinkParser(std::vector<std::string> types) : types_(std::move(types)) {}

  /// Takes the next bytes of the stream, and calls `take` for each message that they complete. Fails with a sentence if
  /// the bytes are not OpenIGTLink: then the rest of the stream cannot be read, and all further calls fail.
  Result<void> feed(std::span<const std::uint8_t> bytes, const Take& take);
  const LinkCounters& counters() const { return counters_; }

 private:
  Result<void> beginBody();
  void endBody(const Take& take);

  std::vector<std::string> types_;
  std::vector<std::uint8_t> part_;  ///< header or body that is not complete yet
  LinkMessage message_;             ///< message whose body is read
  std::uint64_t crc_ = 0;
  std::uint64_t bodyLeft_ = 0;  ///< bytes of the body that are still to come
  bool inBody_ = false, wanted_ = false;
  std::string error_;
  LinkCounters counters_;
};

}  // namespace insonate
