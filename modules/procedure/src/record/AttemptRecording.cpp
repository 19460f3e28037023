#include "record/Block.h"
#include "record/Chain.h"
#include "record/HeaderText.h"
#include "record/SegmentCodec.h"

#include <insonate/procedure/AttemptRecording.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace insonate {

using record::BlockHead;
using record::BlockKind;
using record::Bytes;
using record::PlacedBlock;

namespace {

std::string seconds(std::int64_t time_us) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", static_cast<double>(time_us) * 1e-6);
  return text;
}

Result<Bytes> bytesOf(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return fail("There is no recording " + file.string() + ".");
  if (!std::filesystem::is_regular_file(file, error)) return fail(file.string() + " is not a file.");
  std::ifstream stream(file, std::ios::binary);
  Bytes bytes(stream ? std::filesystem::file_size(file, error) : 0);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!stream) return fail(file.string() + " cannot be read; check its permissions.");
  return bytes;
}

bool hasTooLargeSettings(const std::vector<PlacedBlock>& blocks) {
  std::uint64_t all_bytes = 0;
  for (const PlacedBlock& block : blocks) {
    if (block.head.kind != BlockKind::Header && block.head.kind != BlockKind::Settings) continue;
    if (block.head.rawBytes > record::kMaxSettingsBytes) return true;
    all_bytes += block.head.rawBytes;
  }
  return all_bytes > record::kMaxBytesOfAllSettings;
}

}  // namespace

bool hasRecordingSignature(const std::filesystem::path& file) {
  std::array<std::uint8_t, record::kMark.size()> first{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(first.data()), first.size());
  return stream && first == record::kMark;
}

void RecordingSegment::play(std::int64_t until_us, const std::function<void(const Entry&)>& take) const {
  auto event = events.begin();
  const auto takeEvents = [&](std::size_t taken) {
    for (; event != events.end() && event->afterSamples <= taken; ++event)
      if (event->event.time_us <= until_us) take(event->event);
  };
  for (std::size_t n = 0; n < samples.size() && samples[n].time_us <= until_us; ++n) {
    takeEvents(n);
    take(dequantize(samples[n]));
  }
  takeEvents(samples.size());
}

Result<AttemptRecording> AttemptRecording::open(const std::filesystem::path& file) {
  auto bytes = bytesOf(file);
  if (!bytes) return tl::unexpected(bytes.error());
  AttemptRecording recording;
  recording.name_ = file.string();
  recording.bytes_ = std::move(*bytes);
  std::vector<PlacedBlock> blocks = recording.findBlocks();
  if (hasTooLargeSettings(blocks))
    return fail(recording.name_ + " is not used: its settings are larger than those of any attempt. " +
                "Look for an unchanged copy.");
  if (auto ok = recording.readHeader(blocks); !ok) return tl::unexpected(ok.error());
  if (recording.isChained_)
    if (auto ok = recording.checkLinks(blocks); !ok) return tl::unexpected(ok.error());
  for (const PlacedBlock& block : blocks) recording.readBlock(block);
  recording.reportProblems();
  return recording;
}

std::vector<PlacedBlock> AttemptRecording::findBlocks() {
  const std::span<const std::uint8_t> all(bytes_);
  std::vector<PlacedBlock> blocks;
  for (std::size_t at = 0; at < all.size();) {
    const auto head = record::headAt(all.subspan(at));
    if (!head) {  // continue with the next block that can be found
      const auto next = std::search(all.begin() + static_cast<std::ptrdiff_t>(at) + 1, all.end(), record::kMark.begin(),
                                    record::kMark.end());
      damaged_ |= next != all.end();
      at = static_cast<std::size_t>(next - all.begin());
      continue;
    }
    const std::size_t payload = at + BlockHead::kBytes;
    if (all.size() - payload < head->packedBytes) break;
    blocks.push_back({*head, at});
    at = payload + head->packedBytes;
  }
  return blocks;
}

Result<void> AttemptRecording::readHeader(const std::vector<PlacedBlock>& blocks) {
  const auto found = std::ranges::find(blocks, BlockKind::Header, [](const PlacedBlock& b) { return b.head.kind; });
  if (found == blocks.end()) return fail(name_ + " is not a recording of an attempt, or none of it can be read.");
  const BlockHead& head = found->head;
  const auto text = record::unpacked({&bytes_[found->payload()], head.packedBytes}, head.rawBytes, head.checksum);
  if (!text) return fail(name_ + " cannot be read: its header is damaged.");
  auto read = record::headerFrom({reinterpret_cast<const char*>(text->data()), text->size()});
  if (!read) return fail(name_ + " cannot be read: " + read.error().message);
  header_ = std::move(read->header), isChained_ = read->isChained;
  return {};
}

Result<void> AttemptRecording::checkLinks(std::vector<PlacedBlock>& blocks) {
  const std::size_t found = blocks.size();
  const PlacedBlock last = blocks.back();
  const record::ChainReading chain = record::checkChain(bytes_, blocks);
  for (const record::Link& link : chain.links) links_.push_back({link.digest, link.code});
  const bool beginsWithHeader = !blocks.empty() && blocks.front().head.kind == BlockKind::Header;
  if (!beginsWithHeader || !blocks.front().agrees)
    return fail(name_ +
                " was changed or damaged after it was recorded: its header does not agree with the rest of it. " +
                "Look for an unchanged copy.");
  for (const record::ChainFault& fault : chain.faults) {
    if (fault_.empty())
      fault_ = name_ + " was changed or damaged after it was recorded, at " + seconds(fault.time_us) +
               ". Look for an unchanged copy.";
    // A block that does not match may be right if the one before it is missing.
    missing_ |= fault.kind != record::ChainFault::Kind::Link;
  }
  // In a complete recording no block is missing, and none was added.
  const bool hasOnlyItsOwn = chain.links.size() == blocks.size() && found == 2 * blocks.size() &&
                             last.payload() + last.head.packedBytes == bytes_.size();
  if (fault_.empty() && blocks.back().head.kind == BlockKind::End && !hasOnlyItsOwn)
    fault_ =
        name_ + " was changed after it was recorded: parts were added or removed. " + "Look for an unchanged copy.";
  return {};
}

void AttemptRecording::readBlock(const PlacedBlock& block) {
  const BlockHead& head = block.head;
  switch (head.kind) {
    case BlockKind::RecordingSegment:
      blocks_.push_back(
          {head.first_us, head.last_us, block.payload(), head.packedBytes, head.rawBytes, head.checksum, block.agrees});
      break;
    case BlockKind::Settings:
      readChange(head, block.payload(), block.agrees);
      break;
    case BlockKind::End:
      if (block.agrees) checkEnd(head, block.payload());
      break;
    case BlockKind::Header:
    case BlockKind::Link:
      break;
  }
}

void AttemptRecording::readChange(const BlockHead& head, std::size_t payload, bool agrees) {
  const auto text = record::unpacked({&bytes_[payload], head.packedBytes}, head.rawBytes, head.checksum);
  if (text && agrees) {
    changes_.push_back({head.first_us, {text->begin(), text->end()}});
    return;
  }
  unknownFrom_us_ = std::min(unknownFrom_us_.value_or(head.first_us), head.first_us);
  errors_.push_back(name_ + " is damaged: the settings from " + seconds(head.first_us) +
                    " on are unknown. Later images cannot be rendered again.");
}

void AttemptRecording::checkEnd(const BlockHead& head, std::size_t payload) {
  const auto raw = record::unpacked({&bytes_[payload], head.packedBytes}, head.rawBytes, head.checksum);
  record::ByteReader reader(raw ? std::span<const std::uint8_t>(*raw) : std::span<const std::uint8_t>());
  const auto status = reader.get<std::uint8_t>();
  const auto segmentCount = reader.get<std::uint32_t>();
  const std::uint32_t changes = reader.left() > 0 ? reader.get<std::uint32_t>() : 0;
  if (!reader.isWhole() || status > static_cast<std::uint8_t>(AttemptStatus::Abandoned)) return;
  status_ = static_cast<AttemptStatus>(status);
  damaged_ |= segmentCount != blocks_.size();
  if (changes > changes_.size() && !unknownFrom_us_) unknownFrom_us_ = 0;
}

void AttemptRecording::reportProblems() {
  if (status_ == AttemptStatus::CutShort) {
    errors_.push_back(name_ + " stopped early, so the attempt counts as abandoned; the recording can be read up to " +
                      seconds(end_us()) + ".");
    damaged_ |= missing_;  // no end block states the number of stretches
  }
  const bool stretchIsBad = std::ranges::any_of(blocks_, [](const Block& block) { return !block.agrees; });
  // Damaged settings have been reported with their time.
  if (!fault_.empty() && !damaged_ && (stretchIsBad || !unknownFrom_us_))
    errors_.push_back(fault_ + (stretchIsBad ? " Metrics are not computed." : ""));
  if (damaged_) errors_.push_back(name_ + " is damaged: parts of it cannot be found. Metrics are not computed.");
}

Result<std::string> AttemptRecording::settingsAt(std::int64_t time_us) const {
  if (damaged_ || (unknownFrom_us_ && time_us >= *unknownFrom_us_))
    return fail(name_ + " is damaged: the settings at " + seconds(time_us) + " are not known.");
  const auto after = std::ranges::upper_bound(changes_, time_us, {}, &SettingsChange::time_us);
  return after == changes_.begin() ? header_.settings : std::prev(after)->settings;
}

std::int64_t AttemptRecording::end_us() const {
  return blocks_.empty() ? 0 : blocks_.back().last_us;
}

std::size_t AttemptRecording::segmentAt(std::int64_t time_us) const {
  const auto after = std::ranges::upper_bound(blocks_, time_us, {}, &Block::first_us);
  return after == blocks_.begin() ? 0 : static_cast<std::size_t>(after - blocks_.begin()) - 1;
}

Result<RecordingSegment> AttemptRecording::segment(std::size_t index) const {
  const Block& block = blocks_[index];
  const auto raw = record::unpacked({&bytes_[block.payload], block.packedBytes}, block.rawBytes, block.checksum);
  auto segment = raw ? record::decoded(*raw) : std::nullopt;
  if (segment && !block.agrees)
    return fail(name_ + " was changed after it was recorded, between " + seconds(block.first_us) + " and " +
                seconds(block.last_us) + "; the parts before and after it can be read.");
  if (!segment)
    return fail(name_ + " is damaged between " + seconds(block.first_us) + " and " + seconds(block.last_us) +
                "; the parts before and after it can be read.");
  return std::move(*segment);
}

Result<void> AttemptRecording::play(std::int64_t until_us,
                                    const std::function<void(const RecordingSegment::Entry&)>& take) const {
  if (damaged_) return fail(errors_.back());
  for (std::size_t i = 0; i < blocks_.size() && blocks_[i].first_us <= until_us; ++i) {
    const auto part = segment(i);
    if (!part) return tl::unexpected(part.error());
    part->play(until_us, take);
  }
  return {};
}

Result<MetricValues> AttemptRecording::metricsUntil(std::int64_t time_us) const {
  AttemptMetrics metrics(header_.picture, !header_.vessels.empty());
  const auto played = play(time_us, [&](const RecordingSegment::Entry& entry) {
    std::visit([&](const auto& what) { metrics.add(what); }, entry);
  });
  if (!played) return tl::unexpected(played.error());
  return metrics.values();
}

}  // namespace insonate
