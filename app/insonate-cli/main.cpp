#include "Commands.h"

#include <iostream>

int main(int argc, char** argv) {
  using namespace insonate::cli;
  CLI::App app{"Insonate: a patient's CT becomes an ultrasound image."};
  app.set_version_flag("--version", std::string(INSONATE_VERSION));
  app.require_subcommand(1);

  Outcome outcome;
  addPhantomCommand(app, outcome);
  addRenderCommand(app, outcome);
  addImportCommand(app, outcome);
  addCheckCommand(app, outcome);
  addBenchCommand(app, outcome);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const std::exception& e) {
    std::cerr << "insonate-cli: " << e.what() << '\n';
    return 1;
  }
  return outcome.status;
}
