#include "video/VideoPage.h"

#include "comments/Comments.h"
#include "http/Ranges.h"
#include "video/VideoFiles.h"

#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/VideoQueue.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insonate::web {

const std::pair<std::string, std::string> kVideoPolicy{
    "Content-Security-Policy",
    "default-src 'none'; style-src 'self'; img-src 'self'; media-src 'self'; script-src 'self'; connect-src 'self'; "
    "form-action 'self'; frame-ancestors 'none'; base-uri 'none'"};

namespace {

/// Seconds in which one processor makes a second of a video, before its own speed is known.
constexpr double kUsualSpeed = 4;
constexpr int kRefresh_s = 3;

/// An event of the timeline and its list.
struct Entry {
  enum class Kind { Milestone, Error, Comment };
  std::int64_t time_us = 0;
  Kind kind = Kind::Milestone;
  std::string kindWords{}, description{};
};

std::string nameOf(Severity severity) {
  return severity == Severity::Minor ? "Minor error" : severity == Severity::Major ? "Major error" : "Critical error";
}

std::vector<Entry> entriesOf(const std::vector<AttemptMoment>& moments, const std::vector<AttemptComment>& comments) {
  std::vector<Entry> entries;
  for (const AttemptMoment& one : moments)
    entries.push_back({one.time_us, one.severity ? Entry::Kind::Error : Entry::Kind::Milestone,
                       one.severity ? nameOf(*one.severity) : "", one.description});
  for (const AttemptComment& one : comments)
    entries.push_back({one.at_us, Entry::Kind::Comment, "Comment by " + one.author, one.text});
  std::ranges::stable_sort(entries, {}, &Entry::time_us);
  return entries;
}

std::string secondsOf(std::int64_t time_us) {
  char text[32];
  std::snprintf(text, sizeof text, "%lld.%02lld", static_cast<long long>(time_us / 1'000'000),
                static_cast<long long>(time_us / 10'000 % 100));
  return text;
}

std::string addressOfVideo(const std::string& attempt) {
  return "/attempts/" + encoded(attempt) + "/video.webm";
}

/// Without the script, a link opens the video alone at this time.
Attributes entryLink(const std::string& attempt, const Entry& entry) {
  const std::string time = secondsOf(entry.time_us);
  return {{"href", addressOfVideo(attempt) + "#t=" + time}, {"data-time", time}};
}

std::string entryName(const Entry& entry) {
  return recordingTimeText(entry.time_us) + " " + (entry.kindWords.empty() ? "" : entry.kindWords + ": ") +
         entry.description;
}

/// A disc for a milestone, a triangle for an error, a square for a comment, around the origin. The square behind the
/// mark is the area that a finger or a mouse can hit; its size is that of WCAG 2.2, 2.5.8.
Markup entryMark(Entry::Kind kind) {
  const Markup target =
      element("rect", {{"class", "target"}, {"x", "-12"}, {"y", "-12"}, {"width", "24"}, {"height", "24"}}, "");
  if (kind == Entry::Kind::Milestone) return target + element("circle", {{"class", "milestone"}, {"r", "6"}}, "");
  if (kind == Entry::Kind::Error) return target + element("path", {{"class", "error"}, {"d", "M-7 7L0 -8L7 7Z"}}, "");
  return target +
         element("rect", {{"class", "comment"}, {"x", "-6"}, {"y", "-6"}, {"width", "12"}, {"height", "12"}}, "");
}

/// Marks keep their size on a narrow screen, since only their places depend on the width.
Markup timelineOf(const std::string& attempt, const std::vector<Entry>& entries, std::int64_t length_us) {
  const auto place = [&](std::int64_t time_us) {
    const double fraction = std::clamp(double(time_us) / std::max(1.0, double(length_us)), 0.0, 1.0);
    const std::int64_t tenths = std::llround(1000 * fraction);
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + "%";
  };
  Markup drawing = element("line", {{"class", "axis"}, {"x1", "0"}, {"x2", "100%"}, {"y1", "16"}, {"y2", "16"}}, "");
  for (const Entry& entry : entries)
    drawing += element("a", entryLink(attempt, entry),
                       element("title", {}, entryName(entry)) +
                           element("svg", {{"x", place(entry.time_us)}, {"y", "16"}}, entryMark(entry.kind)));
  drawing += element(
      "line",
      {{"class", "cursor"}, {"x1", "0"}, {"x2", "0"}, {"y1", "0"}, {"y2", "32"}, {"data-length", secondsOf(length_us)}},
      "");
  return element("svg", {{"class", "timeline"}, {"role", "group"}, {"aria-label", "Timeline"}}, drawing);
}

Markup listOf(const std::string& attempt, const std::vector<Entry>& entries) {
  Markup items;
  for (const Entry& entry : entries) {
    Markup words = element("a", entryLink(attempt, entry), recordingTimeText(entry.time_us)) + text(" ");
    if (!entry.kindWords.empty())
      words += element("span", {{"class", entry.kind == Entry::Kind::Error ? "missed" : "quiet"}},
                       (entry.kind == Entry::Kind::Error ? "\u25b2 " : "\u25a0 ") + entry.kindWords + ": ");
    items += element("li", {}, words + text(entry.description));
  }
  return items.empty() ? paragraph("The attempt has no events.") : element("ol", {{"class", "moments"}}, items);
}

Markup player(const std::string& attempt, const std::vector<Entry>& entries, std::int64_t length_us) {
  const Markup video = element("video",
                               {{"controls", ""},
                                {"preload", "metadata"},
                                {"width", "720"},
                                {"height", "720"},
                                {"src", addressOfVideo(attempt)},
                                {"aria-label", "Video of the attempt"}},
                               "");
  return element("div", {{"class", "replay"}},
                 element("div", {}, video + timelineOf(attempt, entries, length_us)) + listOf(attempt, entries)) +
         note("Select an event to go to its time in the video. \u25b2 marks an error, \u25a0 marks a comment.") +
         element("script", {{"src", "/video.js"}, {"defer", ""}}, "");
}

std::string durationWords(double seconds) {
  if (seconds < 90) return "about " + std::to_string(std::max<std::int64_t>(5, std::llround(seconds / 5) * 5)) + " s";
  return "about " + std::to_string(std::llround(seconds / 60)) + " min";
}

std::string progressWords(const VideoState& state) {
  const double usual_s = double(state.length_us) * 1e-6 * kUsualSpeed;
  if (state.stage == VideoState::Stage::Waiting)
    return state.before == 0 ? "The server makes the video now; this takes " + durationWords(usual_s) + "."
                             : "The video waits until " + std::to_string(state.before) +
                                   (state.before == 1 ? " other video is made." : " other videos are made.");
  const double taken_s = double(state.taken_us) * 1e-6;
  const double left_s =
      state.fraction > 0.05 ? taken_s * (1 - state.fraction) / state.fraction : std::max(5.0, usual_s - taken_s);
  return "The video is being made; time left: " + durationWords(left_s) + ".";
}

bool isBusy(const VideoState& state) {
  return state.stage == VideoState::Stage::Waiting || state.stage == VideoState::Stage::Making;
}

std::string classQuery(const Visit& visit) {
  const std::string& cohort = valueOf(visit.request.query, "class");
  return cohort.empty() ? "" : "?class=" + encoded(cohort);
}

/// Tells whether the server can make a video: it needs a recording of an attempt that has ended, within an hour.
bool mayHaveVideo(const Visit& visit, const StoredAttempt& attempt) {
  return VideoFiles(visit.options.videos).isUsed() && !attempt.recordingFile.empty() &&
         attempt.facts.state != AttemptState::Open && attempt.facts.length_us <= kLongestVideo_us;
}

}  // namespace

Result<Markup> videoSection(const Visit& visit, const StoredAttempt& attempt, const std::string& query) {
  const VideoFiles files(visit.options.videos);
  const std::string& id = attempt.facts.id;
  if (!mayHaveVideo(visit, attempt)) return Markup();
  const auto titled = [](const Markup& content) {
    return element("section", {{"id", "video"}}, element("h2", {}, "Video") + content);
  };
  if (files.has(id)) {
    const auto comments = CommentStore(*visit.by).listByAttempt(id);
    if (!comments) return tl::unexpected(comments.error());
    return titled(player(id, entriesOf(files.moments(id), *comments), attempt.facts.length_us));
  }
  const auto state = AttemptVideos(*visit.by).state(id);
  if (!state) return tl::unexpected(state.error());
  const std::string address = "/attempts/" + encoded(id) + "/video" + query;
  if (isBusy(*state))
    return titled(paragraph(progressWords(*state)) + element("p", {}, link(address, "Show the progress of the video")));
  Markup content;
  if (!state->why.empty()) content += troubleLine(state->why);
  content += note(
                 "The video shows the ultrasound image, the needle and the metrics. With the video, this page also "
                 "shows the path of the needle in the image plane. Making the video takes " +
                 durationWords(double(attempt.facts.length_us) * 1e-6 * kUsualSpeed) + ".") +
             postForm(visit, address, {}, "Make video");
  return titled(content);
}

Response requestVideo(const Visit& visit, const Parts& parts) {
  const auto kept = AttemptStore(*visit.by).attempt(parts[0]);
  if (!kept) return refusal(visit, 404, kept.error().message);
  if (!mayHaveVideo(visit, *kept))
    return refusal(visit, 404, "The server has no recording of this attempt, so it cannot make a video.");
  if (!VideoFiles(visit.options.videos).has(parts[0]))
    if (auto requested = AttemptVideos(*visit.by).request(parts[0]); !requested)
      return refusal(visit, 403, requested.error().message);
  return redirect("/attempts/" + encoded(parts[0]) + "/video" + classQuery(visit));
}

Response showVideoProgress(const Visit& visit, const Parts& parts) {
  const auto state = AttemptVideos(*visit.by).state(parts[0]);
  if (!state) return refusal(visit, 404, state.error().message);
  const std::string attempt = "/attempts/" + encoded(parts[0]) + classQuery(visit);
  if (!isBusy(*state)) return redirect(attempt + "#video");
  const Markup content = paragraph(progressWords(*state)) +
                         note(
                             "This page reloads itself, and shows the video when the video is ready. You may leave the "
                             "page; the server continues to make the video.") +
                         element("p", {}, link(attempt, "Back to the attempt"));
  Response response = page(visit, "Video", content);
  response.headers.emplace_back("Refresh", std::to_string(kRefresh_s));
  return response;
}

Response sendVideo(const Visit& visit, const Parts& parts) {
  // Checks the permission, and logs the look.
  const auto state = AttemptVideos(*visit.by).state(parts[0]);
  if (!state) return refusal(visit, 404, state.error().message);
  const VideoFiles files(visit.options.videos);
  if (!files.has(parts[0]))
    return refusal(visit, 404, "This video does not exist yet. Open the page of the attempt to make the video.");
  files.use(parts[0]);
  Response response = sendFile(visit.request, files.video(parts[0]), "video/webm");
  response.headers.push_back(kVideoPolicy);
  return response;
}

}  // namespace insonate::web
