#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

namespace insonate::video {

/// Writes encoded VP9 frames as a WebM file (a subset of Matroska, RFC 9559). Debian's libwebm has headers for reading
/// only. A cluster begins with each key frame, and the cues name each cluster. The caller checks the stream for errors.
class WebmFile {
 public:
  /// Writes the beginning of the file. `out` must be seekable and stay.
  WebmFile(std::ostream& out, int width, int height);
  /// Adds a frame. Times do not decrease; the first frame must be a key frame.
  void add(std::span<const std::uint8_t> packet, std::int64_t time_ms, bool isKey);
  /// Writes cues and duration; nothing may be added afterwards.
  void close(std::int64_t duration_ms);

 private:
  struct Cue {
    std::int64_t time_ms;
    std::uint64_t position;  ///< of the cluster, from the beginning of the segment's content
  };
  void flush();
  void overwrite(std::uint64_t position, const std::string& bytes);

  std::ostream& out_;
  std::uint64_t segment_ = 0;  ///< position of the segment's content in the file; others are relative to it
  std::uint64_t duration_ = 0, cuesEntry_ = 0, written_ = 0;
  std::int64_t cluster_ms_ = 0;
  std::string cluster_;
  std::vector<Cue> cues_;
};

}  // namespace insonate::video
