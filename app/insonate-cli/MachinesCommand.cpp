#include "Commands.h"

#include <insonate/ultrasound/Machine.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

void listMachines(bool asJson) {
  if (!asJson) {
    for (const Machine& machine : machines()) std::cout << machine.name << "\t" << machine.about << '\n';
    return;
  }
  nlohmann::json list = nlohmann::json::array();
  for (const Machine& machine : machines())
    list.push_back({{"name", machine.name}, {"title", machine.title}, {"about", machine.about}});
  printJson({{"machines", list}});
}

}  // namespace

void addMachinesCommand(CLI::App& app, Outcome& outcome) {
  auto asJson = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("machines", "List the classes of ultrasound machines for render --machine");
  command->add_flag("--json", *asJson, "Print a JSON object");
  command->callback([asJson, &outcome] {
    outcome.json = *asJson;
    listMachines(*asJson);
  });
}

}  // namespace insonate::cli
