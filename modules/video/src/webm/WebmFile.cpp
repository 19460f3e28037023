#include "webm/WebmFile.h"

#include <bit>

namespace insonate::video {
namespace {

/// Ids of elements, RFC 9559, with their length markers.
enum Id : std::uint32_t {
  kEbml = 0x1A45DFA3,
  kEbmlVersion = 0x4286,
  kEbmlReadVersion = 0x42F7,
  kEbmlMaxIdLength = 0x42F2,
  kEbmlMaxSizeLength = 0x42F3,
  kDocType = 0x4282,
  kDocTypeVersion = 0x4287,
  kDocTypeReadVersion = 0x4285,
  kSegment = 0x18538067,
  kSeekHead = 0x114D9B74,
  kSeek = 0x4DBB,
  kSeekId = 0x53AB,
  kSeekPosition = 0x53AC,
  kInfo = 0x1549A966,
  kTimestampScale = 0x2AD7B1,
  kDuration = 0x4489,
  kMuxingApp = 0x4D80,
  kWritingApp = 0x5741,
  kTracks = 0x1654AE6B,
  kTrackEntry = 0xAE,
  kTrackNumber = 0xD7,
  kTrackUid = 0x73C5,
  kTrackType = 0x83,
  kFlagLacing = 0x9C,
  kCodecId = 0x86,
  kVideo = 0xE0,
  kPixelWidth = 0xB0,
  kPixelHeight = 0xBA,
  kColor = 0x55B0,
  kMatrixCoefficients = 0x55B1,
  kRange = 0x55B9,
  kTransferCharacteristics = 0x55BA,
  kPrimaries = 0x55BB,
  kCluster = 0x1F43B675,
  kTimestamp = 0xE7,
  kSimpleBlock = 0xA3,
  kCues = 0x1C53BB6B,
  kCuePoint = 0xBB,
  kCueTime = 0xB3,
  kCueTrackPositions = 0xB7,
  kCueTrack = 0xF7,
  kCueClusterPosition = 0xF1,
};

/// A block states its time relative to that of its cluster in 16 bits with sign.
constexpr std::int64_t kLongestCluster_ms = 30'000;

std::string bigEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>(value >> shift);
  return text;
}

std::string idText(std::uint32_t id) {
  return bigEndian(id, id > 0xFFFFFF ? 4 : id > 0xFFFF ? 3 : id > 0xFF ? 2 : 1);
}

/// A size of eight bytes, whose first bit marks its length.
std::string sizeText(std::uint64_t size) {
  return bigEndian(size | std::uint64_t{1} << 56, 8);
}

std::string element(Id id, const std::string& content) {
  return idText(id) + sizeText(content.size()) + content;
}

/// All numbers have eight bytes, so that those known at the end can be written over what stands there before.
std::string number(Id id, std::uint64_t value) {
  return element(id, bigEndian(value, 8));
}

std::string seekTo(Id id, std::uint64_t position) {
  return element(kSeek, element(kSeekId, idText(id)) + number(kSeekPosition, position));
}

std::string head() {
  return element(kEbml, number(kEbmlVersion, 1) + number(kEbmlReadVersion, 1) + number(kEbmlMaxIdLength, 4) +
                            number(kEbmlMaxSizeLength, 8) + element(kDocType, "webm") + number(kDocTypeVersion, 4) +
                            number(kDocTypeReadVersion, 2));
}

std::string tracks(int width, int height) {
  constexpr std::uint64_t kVideoTrack = 1, kBt709 = 1, kLimitedRange = 1;
  const std::string color = element(kColor, number(kMatrixCoefficients, kBt709) + number(kRange, kLimitedRange) +
                                                number(kTransferCharacteristics, kBt709) + number(kPrimaries, kBt709));
  const std::string video = element(kVideo, number(kPixelWidth, static_cast<std::uint64_t>(width)) +
                                                number(kPixelHeight, static_cast<std::uint64_t>(height)) + color);
  return element(kTracks,
                 element(kTrackEntry, number(kTrackNumber, 1) + number(kTrackUid, 1) + number(kTrackType, kVideoTrack) +
                                          number(kFlagLacing, 0) + element(kCodecId, "V_VP9") + video));
}

}  // namespace

WebmFile::WebmFile(std::ostream& out, int width, int height) : out_(out) {
  const std::string beginning = head() + idText(kSegment) + sizeText(0);
  segment_ = beginning.size();
  const auto seekHead = [](std::uint64_t info, std::uint64_t track) {
    return element(kSeekHead, seekTo(kInfo, info) + seekTo(kTracks, track) + seekTo(kCues, 0));
  };
  const std::string name = "insonate";
  const std::string duration = element(kDuration, bigEndian(0, 8));
  const std::string info = element(
      kInfo, number(kTimestampScale, 1'000'000) + element(kMuxingApp, name) + element(kWritingApp, name) + duration);
  const std::uint64_t infoAt = seekHead(0, 0).size(), tracksAt = infoAt + info.size();
  const std::string content = seekHead(infoAt, tracksAt) + info + tracks(width, height);
  cuesEntry_ = infoAt - 8, duration_ = tracksAt - 8;
  out_ << beginning << content;
  written_ = content.size();
}

void WebmFile::add(std::span<const std::uint8_t> packet, std::int64_t time_ms, bool isKey) {
  if (isKey || time_ms - cluster_ms_ > kLongestCluster_ms) {
    flush();
    cluster_ms_ = time_ms;
    if (isKey) cues_.push_back({time_ms, written_});
  }
  constexpr char kTrack = '\x81', kKeyFlag = '\x80';
  std::string block(1, kTrack);
  block += bigEndian(static_cast<std::uint64_t>(time_ms - cluster_ms_), 2) + (isKey ? kKeyFlag : '\0');
  block.append(reinterpret_cast<const char*>(packet.data()), packet.size());
  cluster_ += element(kSimpleBlock, block);
}

void WebmFile::flush() {
  if (cluster_.empty()) return;
  const std::string whole = element(kCluster, number(kTimestamp, static_cast<std::uint64_t>(cluster_ms_)) + cluster_);
  out_ << whole;
  written_ += whole.size();
  cluster_.clear();
}

void WebmFile::close(std::int64_t duration_ms) {
  flush();
  std::string points;
  for (const Cue& cue : cues_)
    points += element(
        kCuePoint, number(kCueTime, static_cast<std::uint64_t>(cue.time_ms)) +
                       element(kCueTrackPositions, number(kCueTrack, 1) + number(kCueClusterPosition, cue.position)));
  const std::string cues = element(kCues, points);
  out_ << cues;
  overwrite(segment_ + cuesEntry_, bigEndian(written_, 8));
  overwrite(segment_ + duration_, bigEndian(std::bit_cast<std::uint64_t>(static_cast<double>(duration_ms)), 8));
  overwrite(segment_ - 8, sizeText(written_ + cues.size()));
  out_.flush();
}

void WebmFile::overwrite(std::uint64_t position, const std::string& bytes) {
  out_.seekp(static_cast<std::streamoff>(position));
  out_ << bytes;
}

}  // namespace insonate::video
