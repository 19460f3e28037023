#pragma once

#include <insonate/ui/Commands.h>

#include <QObject>
#include <QString>
#include <functional>
#include <utility>
#include <vector>

class QSettings;

namespace insonate::prepare {

class PrepareLayout;
struct PrepareModel;

/// One feature of the workspace. The constructor puts the feature's widgets into the layout's slots, connects them with
/// the model and adds the feature's commands. The feature saves its own settings. PrepareWorkspace.cpp lists the
/// features; they are deleted after the widgets, which refer to them, and before the model.
class Feature : public QObject {
 public:
  Feature(PrepareModel& model, PrepareLayout& layout);

  virtual void save(QSettings& /*settings*/) const {}
  virtual void restore(QSettings& /*settings*/) {}
  /// Returns the engine and its frame rate for the status bar; empty if the feature computes no images.
  virtual QString engineText() const { return {}; }

 protected:
  /// Keys (Qt::Key) of a command with their actions.
  using Keys = std::vector<std::pair<int, std::function<void()>>>;

  ui::Commands& commands();
  /// Adds a command, with texts as in ui::Command. The command is available while a case is open and, if `isAvailable`
  /// is given, while `isAvailable` returns true.
  void add(const char* id, const QString& listed, const QString& does, const Keys& keys,
           std::function<bool()> isAvailable = {});

  PrepareModel& model_;
  PrepareLayout& layout_;
};

}  // namespace insonate::prepare
