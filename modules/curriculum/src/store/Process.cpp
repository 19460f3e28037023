#include "store/Process.h"

#include <unistd.h>

#include <QtCore/QByteArray>
#include <QtCore/QSysInfo>
#include <fstream>
#include <sstream>

namespace insonate::store {
namespace {

std::string bootId() {
  std::string id;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
  return id;
}

/// Field 22 of /proc/PID/stat (proc(5)); the second field is a name in brackets that may contain any text. 0 if the
/// process does not exist.
std::int64_t startOf(std::int64_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string stat;
  std::getline(file, stat, '\0');
  std::istringstream fields(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
  std::string field;
  constexpr int kAfterName = 20;
  for (int i = 0; i < kAfterName; ++i) fields >> field;
  return fields ? std::stoll(field) : 0;
}

}  // namespace

Process Process::current() {
  return {QSysInfo::machineUniqueId().toStdString(), bootId(), ::getpid(), startOf(::getpid())};
}

bool Process::isAlive() const {
  return boot == bootId() && started == startOf(pid);
}

}  // namespace insonate::store
