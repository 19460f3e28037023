#include "AttemptDigest.h"

#include <algorithm>
#include <limits>

namespace insonate::review {
namespace {

/// Receives the stream of an attempt and keeps the displayed parts.
class Pass {
 public:
  Pass(AttemptDigest& digest, ProcedureRun run) : digest_(digest), run_(std::move(run)) {}

  void take(const RecordingSegment& segment) {
    segment.play(std::numeric_limits<std::int64_t>::max(), [&](const RecordingSegment::Entry& entry) {
      std::visit([&](const auto& what) { take(what); }, entry);
    });
  }

  void end(bool whole) {
    AttemptScore score = computeScore(run_, digest_.recording->status());
    digest_.moments = score.moments;
    if (whole) digest_.score = std::move(score);
  }

 private:
  void take(const AttemptEvent& event) {
    run_.add(event);
    follow(event.time_us);
  }
  void take(const AttemptSample& sample) {
    run_.add(sample);
    follow(sample.time_us);
    addToTrack(digest_.track, sample, run_.metrics().needle());
  }
  void follow(std::int64_t time_us) {
    const NeedlePlace place = run_.metrics().needle();
    std::string vessel = run_.vesselAtTip();
    if (digest_.places.empty() || digest_.places.back().place != place || digest_.places.back().vessel != vessel)
      digest_.places.push_back({time_us, place, std::move(vessel)});
  }

  AttemptDigest& digest_;
  ProcedureRun run_;
};

}  // namespace

AttemptDigest::PlaceChange AttemptDigest::placeAt(std::int64_t time_us) const {
  const auto after = std::ranges::upper_bound(places, time_us, {}, &PlaceChange::time_us);
  return after == places.begin() ? PlaceChange{} : *std::prev(after);
}

Result<std::shared_ptr<const AttemptDigest>> digestOf(const std::string& file, const Progress& progress) {
  auto opened = AttemptRecording::open(file);
  if (!opened) return tl::unexpected(opened.error());
  auto recording = std::make_shared<const AttemptRecording>(std::move(*opened));
  auto digest = std::make_shared<AttemptDigest>();
  digest->file = file, digest->recording = recording;
  digest->end_us = recording->end_us();
  digest->errors = recording->errors();
  auto procedure = builtInProcedure(recording->header().procedure);
  if (!procedure) digest->errors.push_back("Steps and rules are not shown: " + procedure.error().message);
  const AttemptHeader& header = recording->header();
  Pass pass(*digest, ProcedureRun(procedure.value_or(Procedure{}), header.picture, header.vessels));
  // Blocks that cannot be found are not stretches.
  bool whole = true;
  for (std::size_t i = 0; i < recording->segmentCount(); ++i) {
    if (!report(progress, "reading the attempt", double(i) / double(recording->segmentCount())))
      return fail(std::string(kCancelled));
    const auto segment = recording->segment(i);
    if (segment) {
      pass.take(*segment);
    } else {
      digest->errors.push_back(segment.error().message);
      whole = false;
    }
  }
  pass.end(whole && recording->isWhole());
  return std::shared_ptr<const AttemptDigest>(std::move(digest));
}

}  // namespace insonate::review
