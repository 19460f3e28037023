#include "HidDevice.h"

#include <insonate/haptics/DeviceHub.h>

#include <algorithm>
#include <cstdio>
#include <set>

namespace insonate {
namespace {

using haptics::EventQueue;
using haptics::HidDevice;
using haptics::HidFound;

/// Interval between two checks for devices that do not accept their forces.
constexpr std::chrono::milliseconds kWatch{50};

/// Name that stays the same each time a device is plugged in. Two equal devices differ only by their serial numbers.
std::string kindOf(const HidFound& found) {
  char id[16];
  std::snprintf(id, sizeof id, "%04x:%04x", found.vendor, found.product);
  return found.serial.empty() ? id : id + ("/" + found.serial);
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

bool holds(const std::string& text, const std::string& part) {
  const auto isSame = [](char a, char b) { return lower(a) == lower(b); };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), isSame) != text.end() || part.empty();
}

bool matches(const DeviceMatch& m, const HidFound& found) {
  return m.vendor == found.vendor && m.product == found.product &&
         m.usagePage.value_or(found.usagePage) == found.usagePage && m.usage.value_or(found.usage) == found.usage &&
         holds(found.name, m.name);
}

}  // namespace

DeviceHub::DeviceHub(std::shared_ptr<haptics::HidBus> bus, HubOptions options)
    : bus_(std::move(bus)),
      options_(std::move(options)),
      events_(std::make_shared<EventQueue>()),
      recorder_(std::make_shared<ReportRecorder>()) {}

DeviceHub::~DeviceHub() {
  scanner_ = {};
  for (const Slot& slot : slots_) slot.device->close();
}

void DeviceHub::start() {
  scanner_ = std::jthread([this](const std::stop_token& stop) {
    auto next = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
      if (std::chrono::steady_clock::now() >= next) {
        scanOnce();
        next = std::chrono::steady_clock::now() + options_.rescan;
      }
      // Only this thread changes the list, so that it reads the list without the lock.
      for (const Slot& slot : slots_) slot.device->watch(haptics::monotonic_ns());
      std::unique_lock lock(waitMutex_);
      wait_.wait_for(lock, stop, std::min(kWatch, options_.rescan), [] { return false; });
    }
  });
}

const DeviceTable* DeviceHub::tableFor(const HidFound& found) const {
  for (const DeviceTable& table : options_.tables)
    for (const DeviceMatch& match : table.matches)
      if (matches(match, found)) return &table;
  return nullptr;
}

haptics::HidDevice& DeviceHub::slotFor(const HidFound& found, const DeviceTable& table) {
  const std::string kind = kindOf(found);
  int alike = 0;
  for (const Slot& slot : slots_) {
    if (slot.kind != kind) continue;
    if (!slot.device->attached()) return *slot.device;
    ++alike;
  }
  DeviceInfo info{alike == 0 ? kind : kind + "#" + std::to_string(alike + 1),
                  found.name.empty() ? table.name : found.name, table.kind, found.limits.value_or(table.limits)};
  auto device =
      std::make_shared<HidDevice>(std::move(info), std::make_shared<const DeviceTable>(table), events_, recorder_);
  const std::lock_guard lock(mutex_);
  slots_.push_back({kind, device});
  return *device;
}

void DeviceHub::scanOnce() {
  const std::vector<HidFound> all = bus_->list();
  std::set<std::string> seen;        // hidapi lists an interface once for each of its usages
  std::set<const HidDevice*> tried;  // of two equal devices that cannot be opened, one reports for both
  for (const HidFound& found : all) {
    const DeviceTable* table = tableFor(found);
    if (!table || !seen.insert(found.path).second) continue;
    const bool held = std::any_of(slots_.begin(), slots_.end(), [&](const Slot& slot) {
      return slot.device->attached() && slot.device->path() == found.path;
    });
    if (held) continue;
    HidDevice& device = slotFor(found, *table);
    if (!tried.insert(&device).second) continue;
    device.opening(found.path);
    if (auto handle = bus_->open(found))
      device.attach(std::move(*handle));
    else
      device.cannotOpen(handle.error().message);
  }
  for (const Slot& slot : slots_)
    if (!slot.device->attached() && !seen.contains(slot.device->path())) slot.device->missing();
}

void DeviceHub::add(std::shared_ptr<HapticDevice> device) {
  // The halves of a game controller are added before one is connected.
  if (device->info().kind != DeviceKind::kController)
    events_->put({0, device->info().id, device->phase(), false, device->info().name + " was added."});
  const std::lock_guard lock(mutex_);
  others_.push_back(std::move(device));
}

std::vector<std::shared_ptr<HapticDevice>> DeviceHub::devices() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<HapticDevice>> all;
  for (const Slot& slot : slots_) all.push_back(slot.device);
  all.insert(all.end(), others_.begin(), others_.end());
  return all;
}

std::vector<DeviceEvent> DeviceHub::takeEvents() {
  return events_->take();
}

}  // namespace insonate
