#pragma once

#include <insonate/ultrasound/Probe.h>

#include <QObject>
#include <QString>
#include <vector>

namespace insonate::train {

/// The user's own probes: one file each, of the form of resources/probes, in a folder of the user's. Small files: read
/// and written on the window's thread.
class ProbeLibrary : public QObject {
  Q_OBJECT

 public:
  /// `folder` is made when the first probe is saved; by default "probes" in the application's data folder.
  explicit ProbeLibrary(QString folder = {}, QObject* parent = nullptr);

  struct Entry {
    QString name, file;
    Probe probe;
  };
  /// Saved probes by name; files that hold no probe are left out.
  const std::vector<Entry>& entries() const { return entries_; }
  const Entry* find(const std::string& name) const;

  /// Saves a probe under its name, replacing a probe of that name. Refuses names of built-in probes.
  Result<void> save(const Probe& probe);
  Result<void> rename(const std::string& name, const std::string& newName);
  Result<void> remove(const std::string& name);

 Q_SIGNALS:
  void changed();

 private:
  void read();
  Result<void> write(const Probe& probe, const QString& file);

  QString folder_;
  std::vector<Entry> entries_;
};

/// A probe that comes with the program.
bool isBuiltIn(const std::string& name);

}  // namespace insonate::train
