#include "Commands.h"
#include "Interrupt.h"

#include <insonate/haptics/DeviceHub.h>
#include <insonate/haptics/UdevRules.h>
#include <insonate/haptics/VendorKit.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

namespace insonate::cli {
namespace {

using Json = nlohmann::json;

struct DevicesArguments {
  double seconds = 0.5;
  bool asJson = false, rules = false;
  std::string record;
};

Json toJson(const HapticDevice& device) {
  const DeviceInfo& info = device.info();
  const DeviceLimits& l = info.limits;
  const DeviceCounters c = device.counters();
  return {{"id", info.id},
          {"name", info.name},
          {"kind", nameOf(info.kind)},
          {"phase", nameOf(device.phase())},
          {"trouble", device.error()},
          {"reports", c.reports},
          {"refused_reports", c.refused},
          {"limits",
           {{"sensed_axes", l.sensedAxes},
            {"force_axes", l.forceAxes},
            {"workspace_mm", {l.workspace_mm.x, l.workspace_mm.y, l.workspace_mm.z}},
            {"max_force_N", l.maxForce_N},
            {"continuous_force_N", l.continuousForce_N},
            {"max_torque_Nmm", l.maxTorque_Nmm},
            {"max_stiffness_Npmm", l.maxStiffness_Npmm},
            {"rate_Hz", l.rate_Hz}}}};
}

void print(const HapticDevice& device) {
  const DeviceInfo& info = device.info();
  const DeviceLimits& l = info.limits;
  std::printf("%-28s %-7s %-10s %s", info.id.c_str(), std::string(nameOf(info.kind)).c_str(),
              std::string(nameOf(device.phase())).c_str(), info.name.c_str());
  if (l.sensedAxes > 0)
    std::printf(", %d axes, %.0f x %.0f x %.0f mm", l.sensedAxes, l.workspace_mm.x, l.workspace_mm.y, l.workspace_mm.z);
  if (l.forceAxes > 0) std::printf(", up to %g N", l.maxForce_N);
  if (l.forceAxes > 0 && l.maxStiffness_Npmm > 0) std::printf(" and %g N/mm", l.maxStiffness_Npmm);
  std::printf(", %g Hz\n", l.rate_Hz);
  if (!device.error().empty()) std::printf("  %s\n", device.error().c_str());
}

void print(const DeviceHub& hub) {
  const auto devices = hub.devices();
  for (const auto& device : devices) print(*device);
  if (!devices.empty()) return;
  std::printf("No device that Insonate supports is plugged in. Supported devices:\n");
  for (const DeviceTable& table : builtInDeviceTables())
    std::printf("  %-7s %s\n", std::string(nameOf(table.kind)).c_str(), table.name.c_str());
}

Result<void> listDevices(const DevicesArguments& a) {
  DeviceHub hub(allDevices());
  if (!a.record.empty())
    if (auto begun = hub.recorder().start(a.record); !begun) return begun;
  hub.start();
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(a.seconds);
  Json events = Json::array();
  while (std::chrono::steady_clock::now() < end && interruptSignal() == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for (const DeviceEvent& e : hub.takeEvents()) {
      events.push_back({{"device", e.device}, {"phase", nameOf(e.phase)}, {"trouble", e.error}, {"text", e.text}});
      // During a longer wait, events are shown as they happen.
      if (!a.asJson && a.seconds > 1) std::fprintf(stderr, "%s\n", e.text.c_str());
    }
  }
  if (auto whole = hub.recorder().stop(); !whole) return whole;
  if (!a.asJson) {
    print(hub);
    return {};
  }
  Json devices = Json::array();
  for (const auto& device : hub.devices()) devices.push_back(toJson(*device));
  printJson({{"devices", devices}, {"events", events}});
  return {};
}

}  // namespace

void addDevicesCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand(
      "devices", "List connected haptic devices, 3D mice and pedals with their state, limits and errors");
  auto a = std::make_shared<DevicesArguments>();
  command->add_option("--seconds", a->seconds, "Time for which the devices are read, s")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  command->add_option("--record", a->record, "Write the raw reports of the devices to this file")->check(notEmpty());
  command->add_flag("--udev-rules", a->rules, "Print only the udev rules that give users access to the devices");
  command->add_flag("--json", a->asJson, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->asJson;
    if (a->rules) {
      std::fputs(udevRules().c_str(), stdout);
      return;
    }
    if (auto done = listDevices(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
