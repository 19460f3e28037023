#include "attempt/ReplayCursor.h"

#include <limits>
#include <utility>
#include <variant>

namespace insonate::video {
namespace {

std::int64_t timeOf_us(const RecordingSegment::Entry& entry) {
  return std::visit([](const auto& what) { return what.time_us; }, entry);
}

}  // namespace

ReplayCursor::ReplayCursor(std::shared_ptr<const AttemptRecording> recording, Procedure procedure)
    : recording_(std::move(recording)),
      run_(std::move(procedure), recording_->header().picture, recording_->header().vessels) {}

Result<void> ReplayCursor::advance(std::int64_t time_us) {
  for (;;) {
    for (; next_ < entries_.size(); ++next_) {
      if (timeOf_us(entries_[next_]) > time_us) return {};
      std::visit([this](const auto& what) { take(what); }, entries_[next_]);
    }
    if (stretch_ == recording_->segmentCount()) return {};
    const auto read = recording_->segment(stretch_++);
    if (!read) return tl::unexpected(read.error());
    entries_.clear(), next_ = 0;
    read->play(std::numeric_limits<std::int64_t>::max(),
               [this](const RecordingSegment::Entry& entry) { entries_.push_back(entry); });
  }
}

void ReplayCursor::take(const AttemptSample& sample) {
  run_.add(sample);
  sample_ = sample;
  const SyringeContent now = sample.needleDepth_mm ? aspiratedContent(tipIn_) : SyringeContent::Nothing;
  if (sample.aspirating && now != SyringeContent::Nothing) syringe_ = now;
}

void ReplayCursor::take(const AttemptEvent& event) {
  run_.add(event);
  using enum AttemptEventKind;
  if (event.kind == NeedleReplaced) syringe_ = SyringeContent::Nothing;
  if (event.kind == Entered || event.kind == Left || event.kind == Withdrawn) tipIn_ = event.into;
}

}  // namespace insonate::video
