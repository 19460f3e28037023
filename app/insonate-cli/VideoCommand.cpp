#include "Commands.h"

#include <insonate/simulator/AttemptCase.h>
#include <insonate/video/AttemptClip.h>
#include <insonate/video/AttemptVideo.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <utility>

namespace insonate::cli {
namespace {

struct VideoArguments {
  std::string recording, caseFolder, out;
  AttemptVideoOptions options;
  bool json = false;
};

Result<PatientCase> caseFor(const VideoArguments& a, const AttemptHeader& header) {
  if (a.caseFolder.empty()) return caseOfAttempt(header, {}, terminalProgress());
  auto read = readCase(a.caseFolder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  return std::move(read->patient);
}

/// Tells whether the file becomes a DICOM clip; fails if its name has the ending of another format.
Result<bool> isDicom(const std::string& out) {
  const std::string ending = std::filesystem::path(out).extension().string();
  if (ending == ".dcm" || ending == ".webm") return ending == ".dcm";
  return fail("--out " + out + " must end in .webm (video) or .dcm (DICOM clip).");
}

Result<void> makeVideo(const VideoArguments& a) {
  const auto dicom = isDicom(a.out);
  if (!dicom) return tl::unexpected(dicom.error());
  auto opened = AttemptRecording::open(a.recording);
  if (!opened) return tl::unexpected(opened.error());
  const auto recording = std::make_shared<const AttemptRecording>(std::move(*opened));
  for (const std::string& error : recording->errors()) std::cerr << "note: " << error << '\n';
  auto patient = caseFor(a, recording->header());
  if (!patient) return tl::unexpected(patient.error());
  const auto owned = std::make_shared<const PatientCase>(std::move(*patient));
  const auto write = *dicom ? writeAttemptClip : writeAttemptVideo;
  if (auto ok = write(recording, owned, a.out, a.options, terminalProgress()); !ok) return ok;
  const double length_s = double(recording->end_us()) * 1e-6;
  const auto size_bytes = std::filesystem::file_size(a.out);
  if (a.json)
    printJson({{"out", a.out}, {"length_s", length_s}, {"fps", a.options.framesPerSecond}, {"bytes", size_bytes}});
  else
    std::printf("Wrote %s: %.1f s of the attempt, %d frames per second, %.1f MB\n", a.out.c_str(), length_s,
                a.options.framesPerSecond, double(size_bytes) / 1e6);
  return {};
}

}  // namespace

void addVideoCommand(CLI::App& app, Outcome& outcome) {
  auto* command =
      app.add_subcommand("video",
                         "Write a recorded attempt as a video (WebM: image, needle, syringe and metrics) or its "
                         "ultrasound images as a DICOM clip");
  auto a = std::make_shared<VideoArguments>();
  command->add_option("RECORDING", a->recording, "File of a recording")->required()->check(notEmpty());
  command->add_option("CASE", a->caseFolder, "Folder of the attempt's case; not needed for a built-in neck")
      ->check(notEmpty());
  command->add_option("--out", a->out, "File to write: .webm (video) or .dcm (DICOM ultrasound clip)")
      ->required()
      ->check(notEmpty());
  command->add_option("--fps", a->options.framesPerSecond, "Frames per second")
      ->check(CLI::Range(1, 60))
      ->capture_default_str();
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->json;
    if (auto done = makeVideo(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
