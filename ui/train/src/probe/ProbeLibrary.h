#pragma once

#include <insonate/ultrasound/Probe.h>

#include <QObject>
#include <QString>
#include <vector>

namespace insonate::train {

/// The user's own probes, each in one file of the format of resources/probes, in one of the user's folders. The files
/// are small, and are read and written on the window's thread.
class ProbeLibrary : public QObject {
  Q_OBJECT

 public:
  /// `folder` is created when the first probe is saved; by default "probes" in the application's data folder.
  explicit ProbeLibrary(QString folder = {}, QObject* parent = nullptr);

  struct Entry {
    QString name, file;
    Probe probe;
  };
  /// Saved probes sorted by name; files without a valid probe are left out.
  const std::vector<Entry>& entries() const { return entries_; }
  const Entry* find(const std::string& name) const;

  /// Saves a probe under its name, replacing a probe of that name. Fails for names of built-in probes.
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

/// Tells whether this is the name of a built-in probe.
bool isBuiltIn(const std::string& name);

}  // namespace insonate::train
