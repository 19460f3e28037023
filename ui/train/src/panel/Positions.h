#pragma once

#include <insonate/cases/PatientCase.h>

#include <QMap>
#include <QString>
#include <QWidget>
#include <vector>

class QListWidget;
class QPushButton;
class QSettings;

namespace insonate::train {

class TrainSession;

/// Places for the probe to go back to: those of the case, then the user's own, which are remembered for each case.
class Positions : public QWidget {
 public:
  explicit Positions(TrainSession& session, QWidget* parent = nullptr);

  int count() const;
  /// From 0; nothing happens beyond the list.
  void recall(int place);
  /// Where the probe is now, as one of the user's own.
  void saveCurrent();
  /// One of the user's own; the case's stay.
  void remove(int place);

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  QString caseKey() const;
  std::vector<StartPose> ofCase() const;
  std::vector<StartPose> all() const;

  TrainSession& session_;
  QListWidget* list_;
  QPushButton* saveButton_;
  QMap<QString, std::vector<StartPose>> own_;
};

}  // namespace insonate::train
