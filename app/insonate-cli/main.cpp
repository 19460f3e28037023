#include "Commands.h"
#include "Interrupt.h"

#include <insonate/core/Words.h>

#include <algorithm>
#include <iostream>

namespace {

using namespace insonate;

/// A first word that is neither an option nor a command; empty otherwise.
std::string unknownCommand(const CLI::App& app, int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  std::vector<std::string_view> known;
  for (const CLI::App* command : app.get_subcommands(nullptr)) known.push_back(command->get_name());
  if (first.empty() || first.starts_with('-') || std::ranges::find(known, first) != known.end()) return {};
  const std::string_view near = nearestWord(first, known);
  return "There is no command '" + first + "'" +
         (near.empty() ? "" : std::string("; did you mean '").append(near).append("'?")) +
         (near.empty() ? "; known are " : " Known are ") + joinedWords(known) + ".";
}

}  // namespace

int main(int argc, char** argv) {
  using namespace insonate::cli;
  CLI::App app{"Insonate computes ultrasound images from a patient's CT."};
  app.set_version_flag("--version", std::string(INSONATE_VERSION));
  app.require_subcommand(1);

  Outcome outcome;
  addPhantomCommand(app, outcome);
  addRenderCommand(app, outcome);
  addSpectrumCommand(app, outcome);
  addMachinesCommand(app, outcome);
  addImportCommand(app, outcome);
  addImportLabelsCommand(app, outcome);
  addExportCommand(app, outcome);
  addCropCommand(app, outcome);
  addLabelCommand(app, outcome);
  addCheckCommand(app, outcome);
  addPrepareCommand(app, outcome);
  addPublishCommand(app, outcome);
  addBenchCommand(app, outcome);
  addSurfacesCommand(app, outcome);
  addFitCommand(app, outcome);
  addDevicesCommand(app, outcome);
  addSessionCommand(app, outcome);
  addReplayCommand(app, outcome);
  addVideoCommand(app, outcome);
  addWireCommand(app, outcome);
  addHandsCommand(app, outcome);
  addLinkCommand(app, outcome);
  addCurriculumCommand(app, outcome);

  if (const std::string unknown = unknownCommand(app, argc, argv); !unknown.empty()) {
    std::cerr << "insonate-cli: " << unknown << '\n';
    return 2;
  }
  catchInterrupts();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const std::bad_alloc&) {
    refuse(outcome, {"There is not enough memory. Close other programs or use a smaller volume."});
  } catch (const std::exception& e) {
    refuse(outcome, {e.what()});
  }
  return outcome.status;
}
