#include "realism/RealismPage.h"

#include "report/CellTable.h"

#include <insonate/core/Words.h>
#include <insonate/ultrasound/SetupText.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace insonate::bench {
namespace {

constexpr const char* kPageHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Simulated and real ultrasound images</title><style>
body{font:16px/1.5 sans-serif;margin:0 auto;max-width:78em;padding:1.5em;color:#222}
table{border-collapse:collapse;font-size:.9em}td,th{padding:.25em .6em;border-bottom:1px solid #ddd;text-align:left}
td.n{text-align:right;white-space:nowrap}.track{position:relative;width:220px;height:16px;background:#f2f2f2}
.track i{position:absolute;top:0;bottom:0}.floor{background:#cfe3cf}.middle{width:1px;background:#888}
.interval{top:7px!important;bottom:7px!important;background:#555}.area{width:6px;margin-left:-3px;background:#06c}
tr.beyond .area{background:#c30}figure{display:inline-block;margin:.6em;vertical-align:top;width:20em}
figure img{width:100%;background:#000}figcaption{font-size:.8em;color:#555;overflow-wrap:anywhere}
td:first-child{min-width:17em}
</style></head><body><h1>Simulated and real ultrasound images</h1>
)";

constexpr const char* kProtocol = R"(<h2>Reading test</h2>
<p>The folder <code>blind</code> holds the images below in random order, without names. Readers open
<code>sheet.html</code> in it, which shows the protocol and then one image after another.</p><ol>
<li>Choose at least three, better five or more readers who scan or read necks, and at least 20 real and 20 simulated images
of several machines and patients.</li>
<li>Give each reader the folder <code>blind</code> alone, a code, and no feedback. The reader must not have seen these images
or this page.</li>
<li>Each reader uses the screen and the light in which scans are read, rates all images alone, and returns
the saved file, <code>ratings-CODE.csv</code>.</li>
<li>Score all readers together: <code>insonate-cli bench realism --out DIR --ratings FILE...</code>. It prints sensitivity,
specificity, and the ROC area with a 95 % interval that holds for other readers and other images.</li>
<li>State the interval with the result. Readers cannot tell the images apart if the whole interval is near 0.5, e.g. from 0.4
to 0.6. An area near 0.5 with a wide interval means that there were too few readers or images.</li>
<li>Read the remarks at the end of each of these files: they name what to improve next.</li></ol>
)";

std::string areaText(const RocArea& told) {
  return fixed(told.area, 2) + " (" + fixed(told.low, 2) + " to " + fixed(told.high, 2) + ")";
}

/// Position of an ROC area on the track.
std::string percent(double area) {
  return fixed(100 * std::clamp(area, 0.0, 1.0), 1) + "%";
}

std::string track(const RealismFeature& f) {
  std::string html = "<div class=\"track\">";
  if (std::isfinite(f.floor))
    html +=
        "<i class=\"floor\" style=\"left:" + percent(1 - f.floor) + ";width:" + percent(2 * f.floor - 1) + "\"></i>";
  return html +
         "<i class=\"middle\" style=\"left:50%\"></i><i class=\"interval\" style=\"left:" + percent(f.separation.low) +
         ";width:" + percent(f.separation.high - f.separation.low) +
         "\"></i><i class=\"area\" style=\"left:" + percent(f.separation.area) + "\"></i></div>";
}

/// About three digits.
std::string shortText(double value) {
  const double size = std::abs(value);
  return fixed(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

std::string rangeText(double median, double low, double high) {
  return shortText(median) + " [" + shortText(low) + ", " + shortText(high) + "]";
}

std::string comparisonHtml(const RealismComparison& comparison) {
  std::string name(nameOf(comparison.probe));
  name.front() = char(std::toupper(name.front()));
  const auto beyond = std::ranges::count_if(comparison.features, &RealismFeature::exceedsFloor);
  std::string html =
      "<h2>" + name + " probe: " + std::to_string(comparison.real) + " real and " +
      std::to_string(comparison.simulated) + " simulated images</h2>\n<p>" + std::to_string(beyond) + " of " +
      std::to_string(comparison.features.size()) +
      " features distinguish the sets better than real sources are distinguished from each other. A "
      "linear classifier of all features that never saw the source that it judges reaches an ROC area "
      "of " +
      areaText(comparison.classifier) +
      ".</p>\n<table><tr><th>feature</th><th>real: median [p10, p90]</th><th>simulated</th><th>ROC area, "
      "0 to 1</th><th></th><th>floor</th><th>p</th></tr>\n";
  for (const RealismFeature& f : comparison.features)
    html += std::string(f.exceedsFloor() ? "<tr class=\"beyond\"><td><b>" : "<tr><td>") + escapedMarkup(f.name) +
            (f.exceedsFloor() ? "</b>" : "") + "</td><td class=\"n\">" + rangeText(f.real, f.realLow, f.realHigh) +
            "</td><td class=\"n\">" + rangeText(f.simulated, f.simulatedLow, f.simulatedHigh) + "</td><td>" + track(f) +
            "</td><td class=\"n\">" + areaText(f.separation) + "</td><td class=\"n\">" +
            (std::isfinite(f.floor) ? fixed(f.floor, 2) : "no data") + "</td><td class=\"n\">" + fixed(f.p, 4) +
            "</td></tr>\n";
  return html + "</table>\n";
}

std::string figure(const BlindImage& image, std::size_t n, const std::string& folder) {
  const SheetItem item = filesOf(image, n);
  std::string frames;
  for (const std::string& file : item.files) frames += (frames.empty() ? "" : " ") + folder + file;
  return "<figure><img loading=\"lazy\" src=\"" + folder + item.files[item.files.size() / 2] + "\"" +
         (item.files.size() > 1 ? " data-frames=\"" + frames + "\"" : "") + " alt=\"\"><figcaption>" +
         std::to_string(n + 1) + ", " + (image.simulated ? "simulated" : "real") + ": " +
         escapedMarkup(image.image->about) + "</figcaption></figure>\n";
}

std::string gallery(const std::vector<BlindImage>& images, const std::string& folder) {
  std::string html;
  for (const bool simulated : {false, true})
    for (std::size_t n = 0; n < images.size(); ++n)
      if (images[n].simulated == simulated) html += figure(images[n], n, folder);
  return html;
}

}  // namespace

std::string realismPage(const RealismBench& bench, const BlindImages& images) {
  std::string html = kPageHead;
  html +=
      "<p>Every feature is a number that describes an image. The ROC area is the share of pairs, one real and one "
      "simulated image, in which the simulated image has the greater number: at 0.5 (gray line) the feature cannot "
      "distinguish them, at 0 or 1 it always does. The dark bar is its 95 % interval. The floor (green) is how far one "
      "real source, e.g. one machine, lies from all others; nothing needs to be better than that. Features in bold "
      "with "
      "a red mark lie beyond the floor, with p below 0.05 after correction for the number of features (Holm).</p>\n";
  if (bench.comparisons.empty())
    html += "<p>The list has no real images of the probes that were simulated: there is nothing to compare.</p>\n";
  for (const RealismComparison& comparison : bench.comparisons) html += comparisonHtml(comparison);
  if (!images.matched.empty())
    html += std::string(kProtocol) + "<h2>Images of the reading test, with their sources</h2>\n" +
            gallery(images.matched, "blind/");
  if (!images.unmatched.empty())
    html +=
        "<h2>Images outside the reading test</h2>\n<p>Only one of the sets has images of this kind (probe, still or "
        "clip), so that the kind would give them away.</p>\n" +
        gallery(images.unmatched, "unmatched/");
  return html + clipScript() + "</body></html>\n";
}

}  // namespace insonate::bench
