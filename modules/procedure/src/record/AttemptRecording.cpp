#include "record/Block.h"
#include "record/HeaderText.h"
#include "record/StretchCodec.h"

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

}  // namespace

bool beginsAsRecording(const std::filesystem::path& file) {
  std::array<std::uint8_t, record::kMark.size()> first{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(first.data()), first.size());
  return stream && first == record::kMark;
}

void Stretch::play(std::int64_t until_us, const std::function<void(const Entry&)>& take) const {
  auto event = events.begin();
  const auto takeEvents = [&](std::size_t taken) {
    for (; event != events.end() && event->afterSamples <= taken; ++event)
      if (event->event.time_us <= until_us) take(event->event);
  };
  for (std::size_t n = 0; n < samples.size() && samples[n].time_us <= until_us; ++n) {
    takeEvents(n);
    take(restored(samples[n]));
  }
  takeEvents(samples.size());
}

Result<AttemptRecording> AttemptRecording::open(const std::filesystem::path& file) {
  auto bytes = bytesOf(file);
  if (!bytes) return tl::unexpected(bytes.error());
  AttemptRecording recording;
  recording.name_ = file.string();
  recording.bytes_ = std::move(*bytes);
  const std::span<const std::uint8_t> all(recording.bytes_);
  for (std::size_t at = 0; at < all.size();) {
    const auto head = record::headAt(all.subspan(at));
    if (!head) {  // go on with the next block that can be found
      const auto next = std::search(all.begin() + at + 1, all.end(), record::kMark.begin(), record::kMark.end());
      recording.damaged_ |= next != all.end();
      at = static_cast<std::size_t>(next - all.begin());
      continue;
    }
    const std::size_t payload = at + BlockHead::kBytes;
    if (all.size() - payload < head->packedBytes) break;
    if (auto ok = recording.readBlock(*head, payload); !ok) return tl::unexpected(ok.error());
    at = payload + head->packedBytes;
  }
  if (!recording.hasHeader_)
    return fail(file.string() + " is not a recording of an attempt, or nothing of it is left that can be read.");
  if (recording.status_ == AttemptStatus::CutShort)
    recording.troubles_.push_back(file.string() +
                                  " broke off, so the attempt counts as abandoned; it can be read up to " +
                                  seconds(recording.end_us()) + ".");
  if (recording.damaged_)
    recording.troubles_.push_back(file.string() +
                                  " is damaged: parts of it cannot be found. Metrics are not computed.");
  return recording;
}

Result<void> AttemptRecording::readBlock(const BlockHead& head, std::size_t payload) {
  switch (head.kind) {
    case BlockKind::Header:
      return readHeader(head, payload);
    case BlockKind::Stretch:
      blocks_.push_back({head.first_us, head.last_us, payload, head.packedBytes, head.rawBytes, head.checksum});
      break;
    case BlockKind::Settings:
      readChange(head, payload);
      break;
    case BlockKind::End:
      checkEnd(head, payload);
      break;
  }
  return {};
}

Result<void> AttemptRecording::readHeader(const BlockHead& head, std::size_t payload) {
  const auto text = record::unpacked({&bytes_[payload], head.packedBytes}, head.rawBytes, head.checksum);
  if (!text) return fail(name_ + " cannot be read: its header is damaged.");
  auto header = record::headerFrom({reinterpret_cast<const char*>(text->data()), text->size()});
  if (!header) return fail(name_ + " cannot be read: " + header.error().message);
  header_ = std::move(*header), hasHeader_ = true;
  return {};
}

void AttemptRecording::readChange(const BlockHead& head, std::size_t payload) {
  const auto text = record::unpacked({&bytes_[payload], head.packedBytes}, head.rawBytes, head.checksum);
  if (text) {
    changes_.push_back({head.first_us, {text->begin(), text->end()}});
    return;
  }
  unknownFrom_us_ = std::min(unknownFrom_us_.value_or(head.first_us), head.first_us);
  troubles_.push_back(name_ + " is damaged: how it was set from " + seconds(head.first_us) +
                      " on is not known. Pictures from there on cannot be made again.");
}

void AttemptRecording::checkEnd(const BlockHead& head, std::size_t payload) {
  const auto raw = record::unpacked({&bytes_[payload], head.packedBytes}, head.rawBytes, head.checksum);
  record::ByteReader reader(raw ? std::span<const std::uint8_t>(*raw) : std::span<const std::uint8_t>());
  const auto status = reader.get<std::uint8_t>();
  const auto stretches = reader.get<std::uint32_t>();
  const std::uint32_t changes = reader.left() > 0 ? reader.get<std::uint32_t>() : 0;
  if (!reader.isWhole() || status > static_cast<std::uint8_t>(AttemptStatus::Abandoned)) return;
  status_ = static_cast<AttemptStatus>(status);
  damaged_ |= stretches != blocks_.size();
  if (changes > changes_.size() && !unknownFrom_us_) unknownFrom_us_ = 0;
}

Result<std::string> AttemptRecording::settingsAt(std::int64_t time_us) const {
  if (damaged_ || (unknownFrom_us_ && time_us >= *unknownFrom_us_))
    return fail(name_ + " is damaged: how it was set at " + seconds(time_us) + " is not known.");
  const auto after = std::ranges::upper_bound(changes_, time_us, {}, &SettingsChange::time_us);
  return after == changes_.begin() ? header_.settings : std::prev(after)->settings;
}

std::int64_t AttemptRecording::end_us() const {
  return blocks_.empty() ? 0 : blocks_.back().last_us;
}

std::size_t AttemptRecording::stretchAt(std::int64_t time_us) const {
  const auto after = std::ranges::upper_bound(blocks_, time_us, {}, &Block::first_us);
  return after == blocks_.begin() ? 0 : static_cast<std::size_t>(after - blocks_.begin()) - 1;
}

Result<Stretch> AttemptRecording::stretch(std::size_t index) const {
  const Block& block = blocks_[index];
  const auto raw = record::unpacked({&bytes_[block.payload], block.packedBytes}, block.rawBytes, block.checksum);
  auto stretch = raw ? record::decoded(*raw) : std::nullopt;
  if (!stretch)
    return fail(name_ + " is damaged between " + seconds(block.first_us) + " and " + seconds(block.last_us) +
                "; what is before and after can be read.");
  return std::move(*stretch);
}

Result<void> AttemptRecording::play(std::int64_t until_us,
                                    const std::function<void(const Stretch::Entry&)>& take) const {
  if (damaged_) return fail(troubles_.back());
  for (std::size_t i = 0; i < blocks_.size() && blocks_[i].first_us <= until_us; ++i) {
    const auto part = stretch(i);
    if (!part) return tl::unexpected(part.error());
    part->play(until_us, take);
  }
  return {};
}

Result<MetricValues> AttemptRecording::metricsUntil(std::int64_t time_us) const {
  AttemptMetrics metrics(header_.picture, !header_.vessels.empty());
  const auto played = play(
      time_us, [&](const Stretch::Entry& entry) { std::visit([&](const auto& what) { metrics.take(what); }, entry); });
  if (!played) return tl::unexpected(played.error());
  return metrics.values();
}

}  // namespace insonate
