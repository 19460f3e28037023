#pragma once

#include "Reports.h"

#include <fcntl.h>
#include <glib-object.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <umockdev.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace insonate::test {

/// A machine without devices: this process, run by umockdev-wrapper, sees its /sys and /dev. umockdev answers on a
/// thread of its own.
class MockMachine {
 public:
  MockMachine() : bed_(umockdev_testbed_new()) {}
  ~MockMachine() { g_object_unref(bed_); }
  MockMachine(const MockMachine&) = delete;
  MockMachine& operator=(const MockMachine&) = delete;

  UMockdevTestbed* bed() const { return bed_; }

 private:
  UMockdevTestbed* bed_;
};

/// A HID device as the kernel shows it: its place in /sys, and /dev/hidrawN, which answers the ioctls for the report
/// descriptor and gives and takes whole reports. The node behind it is a terminal, which has no reports: it carries
/// one byte for each report that waits, so that poll() tells the truth.
class MockHidraw {
 public:
  MockHidraw(MockMachine& machine, int number, std::uint16_t vendor, std::uint16_t product, const std::string& name,
             const std::string& serial, Bytes descriptor)
      : machine_(machine), descriptor_(std::move(descriptor)), node_("/dev/hidraw" + std::to_string(number)) {
    char ids[64];
    std::snprintf(ids, sizeof ids, "0003:%08X:%08X", vendor, product);
    // Names are unique in a class of devices, wherever they hang.
    port_ = "/devices/usb/" + std::to_string(number + 1) + "-1";
    interface_ = port_ + "/" + std::to_string(number + 1) + "-1:1.0";
    hid_ = interface_ + "/0003:" + std::to_string(number);
    addToBed("P: " + port_ + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: manufacturer=Maker\\n\nA: product=" + name +
             "\\n\nA: serial=" + serial + "\\n\nA: bcdDevice=0100\\n\n");
    addToBed("P: " + interface_ + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\\n\n");
    addToBed("P: " + hid_ + "\nE: SUBSYSTEM=hid\nA: uevent=HID_ID=" + ids + "\\nHID_NAME=" + name +
             "\\nHID_UNIQ=" + serial + "\\n\nH: report_descriptor=" + hex(descriptor_) + "\n");
    addToBed("P: " + hidraw() + "\nN: hidraw" + std::to_string(number) + "\nE: SUBSYSTEM=hidraw\nE: DEVNAME=" + node_ +
             "\nL: device=../../../" + hid_.substr(hid_.rfind('/') + 1) + "\n");
    openTerminal();
    attach();
  }
  ~MockHidraw() {
    if (!gone()) unplug();
    umockdev_testbed_detach_ioctl(machine_.bed(), node_.c_str(), nullptr);
    g_object_unref(handler_);
    ::close(slave_);
  }
  MockHidraw(const MockHidraw&) = delete;
  MockHidraw& operator=(const MockHidraw&) = delete;

  void say(Bytes report) {
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back(std::move(report));
    }
    wake();
  }
  std::vector<Bytes> heard() const {
    const std::lock_guard lock(mutex_);
    return heard_;
  }
  /// Out of /sys; reads and writes of whoever holds the node end in errors, as the kernel has it.
  void unplug() {
    {
      const std::lock_guard lock(mutex_);
      gone_ = true;
    }
    wake();
    for (const std::string& path : {hidraw(), hid_, interface_, port_})
      umockdev_testbed_remove_device(machine_.bed(), ("/sys" + path).c_str());
  }

 private:
  std::string hidraw() const { return hid_ + "/hidraw/" + node_.substr(5); }
  bool gone() const {
    const std::lock_guard lock(mutex_);
    return gone_;
  }
  void wake() {
    const char byte = 1;
    if (::write(master_, &byte, 1) != 1) throw std::runtime_error("the mock's terminal is full");
  }
  static std::string hex(const Bytes& bytes) {
    std::string text;
    char digits[3];
    for (const auto b : bytes) {
      std::snprintf(digits, sizeof digits, "%02X", b);
      text += digits;
    }
    return text;
  }
  void addToBed(const std::string& description) {
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(machine_.bed(), description.c_str(), &error))
      throw std::runtime_error(std::string("umockdev: ") + error->message);
  }
  void attach() {
    handler_ = umockdev_ioctl_base_new();
    g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(&MockHidraw::onIoctl), this);
    g_signal_connect(handler_, "handle-read", G_CALLBACK(&MockHidraw::onRead), this);
    g_signal_connect(handler_, "handle-write", G_CALLBACK(&MockHidraw::onWrite), this);
    GError* error = nullptr;
    if (!umockdev_testbed_attach_ioctl(machine_.bed(), node_.c_str(), handler_, &error))
      throw std::runtime_error(std::string("umockdev: ") + error->message);
  }

  static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    const Bytes& descriptor = static_cast<MockHidraw*>(self)->descriptor_;
    const gulong request = umockdev_ioctl_client_get_request(client);
    if (request == HIDIOCGRDESCSIZE) {
      const int size = static_cast<int>(descriptor.size());
      return answer(client, 0, &size, sizeof size);
    }
    if (request == HIDIOCGRDESC) {
      hidraw_report_descriptor all{};
      all.size = static_cast<std::uint32_t>(descriptor.size());
      std::copy(descriptor.begin(), descriptor.end(), all.value);
      return answer(client, 0, &all, sizeof all);
    }
    return FALSE;
  }
  static gboolean answer(UMockdevIoctlClient* client, long result, const void* data, std::size_t size) {
    UMockdevIoctlData* all = umockdev_ioctl_client_get_arg(client);
    UMockdevIoctlData* place = umockdev_ioctl_data_resolve(all, 0, size, nullptr);
    umockdev_ioctl_data_update(place, 0, reinterpret_cast<guint8*>(const_cast<void*>(data)), static_cast<int>(size));
    umockdev_ioctl_client_complete(client, result, 0);
    return TRUE;
  }
  static gboolean onRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer pointer) {
    auto* self = static_cast<MockHidraw*>(pointer);
    const std::lock_guard lock(self->mutex_);
    if (self->gone_) {
      umockdev_ioctl_client_complete(client, -1, EIO);
      return TRUE;
    }
    if (self->waiting_.empty()) {
      umockdev_ioctl_client_complete(client, -1, EAGAIN);
      return TRUE;
    }
    const Bytes report = std::move(self->waiting_.front());
    self->waiting_.pop_front();
    self->drainOne();
    UMockdevIoctlData* buffer = umockdev_ioctl_client_get_arg(client);
    const int size = std::min(static_cast<int>(report.size()), buffer->data_len);
    umockdev_ioctl_data_update(buffer, 0, const_cast<guint8*>(report.data()), size);
    umockdev_ioctl_client_complete(client, size, 0);
    return TRUE;
  }
  static gboolean onWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer pointer) {
    auto* self = static_cast<MockHidraw*>(pointer);
    const std::lock_guard lock(self->mutex_);
    if (self->gone_) {
      umockdev_ioctl_client_complete(client, -1, ENODEV);
      return TRUE;
    }
    UMockdevIoctlData* buffer = umockdev_ioctl_client_get_arg(client);
    self->heard_.emplace_back(buffer->data, buffer->data + buffer->data_len);
    umockdev_ioctl_client_complete(client, buffer->data_len, 0);
    return TRUE;
  }
  /// The report's byte out of the terminal, past the mock.
  void drainOne() const {
    char byte = 0;
    if (::read(slave_, &byte, 1) != 1) throw std::runtime_error("the mock's terminal is empty");
  }
  void openTerminal() {
    master_ = umockdev_testbed_get_dev_fd(machine_.bed(), node_.c_str());
    gchar* root = umockdev_testbed_get_root_dir(machine_.bed());
    slave_ = ::open((root + node_).c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
    g_free(root);
    termios settings{};
    if (slave_ < 0 || ::tcgetattr(slave_, &settings) != 0) throw std::runtime_error("the mock has no terminal");
    ::cfmakeraw(&settings);
    ::tcsetattr(slave_, TCSANOW, &settings);
  }

  MockMachine& machine_;
  const Bytes descriptor_;
  const std::string node_;
  std::string port_, interface_, hid_;
  UMockdevIoctlBase* handler_ = nullptr;
  int master_ = -1, slave_ = -1;
  mutable std::mutex mutex_;
  std::deque<Bytes> waiting_;
  std::vector<Bytes> heard_;
  bool gone_ = false;
};

}  // namespace insonate::test
