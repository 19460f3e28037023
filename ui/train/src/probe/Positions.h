#pragma once

#include <insonate/cases/PatientCase.h>

#include <QMap>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

class QListWidget;
class QListWidgetItem;
class QMenu;
class QPushButton;
class QSettings;

namespace insonate::train {

class CaseModel;
class History;
class ProbeMotion;
class StatusLine;

/// List of positions to which the probe can be moved: first the positions of the case, then the user's own positions,
/// which are saved for each case.
class Positions : public QWidget {
 public:
  Positions(StatusLine& status, History& history, CaseModel& patientCase, ProbeMotion& motion,
            QWidget* parent = nullptr);

  int count() const;
  /// Moves the probe to a position of the list, counted from 0; no effect for other numbers.
  void recall(int place);
  /// Saves the probe's present position as one of the user's own.
  void saveCurrent();
  /// Removes one of the user's own positions; positions of the case cannot be removed.
  void remove(int place);
  void rename(int place, const QString& name);
  void shift(int place, int by);

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Own = std::vector<StartPose>;
  QMenu* buildMenu();
  void nameEdited(QListWidgetItem* item);
  /// Returns the index of this row among the user's own positions. For a position of the case, returns nothing and
  /// shows a message.
  std::optional<std::size_t> ownAt(int place);
  void change(Own next, const QString& what, int current);
  void refresh();
  QString caseKey() const;
  std::vector<StartPose> ofCase() const;
  std::vector<StartPose> all() const;

  StatusLine& status_;
  History& history_;
  CaseModel& patientCase_;
  ProbeMotion& motion_;
  QListWidget* list_;
  QPushButton* saveButton_;
  QPushButton* menuButton_;
  bool refreshing_ = false;
  bool going_ = false;  ///< true: the probe is being moved to a position of the list
  QMap<QString, std::vector<StartPose>> own_;
};

}  // namespace insonate::train
