#pragma once

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CommentStore.h>

#include <QString>
#include <QWidget>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace insonate::ui {
class Account;
class Chart;
}  // namespace insonate::ui

namespace insonate::train {

class Course;

/// Lists the user's own attempts, the newest first, and shows the learning curve of a metric over the attempts that
/// count.
class HistoryPage final : public QWidget {
  Q_OBJECT

 public:
  HistoryPage(Course& course, ui::Account* account, QWidget* parent = nullptr);

 Q_SIGNALS:
  void attemptRequested(const QString& file);
  void messageReported(const QString& sentence);
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildList();
  QWidget* buildCurve();
  void refresh();
  void ask(std::int64_t before);
  void append(const std::vector<StoredAttempt>& page);
  void askComments();
  void showComments();
  void refreshWords();
  void refreshChoices();
  void refreshCurve();
  void open();

  Course& course_;
  ui::Account* account_;
  std::vector<StoredAttempt> attempts_;                  ///< the attempts in the order of the table's rows
  std::map<std::string, CommentStore::Count> comments_;  ///< numbers of comments, by attempt id
  bool asked_ = false, more_ = false;
  int asking_ = 0;  ///< number of the last query; results of earlier queries are dropped
  QString error_;
  QLabel* words_ = nullptr;
  QTableWidget* table_ = nullptr;
  QPushButton *open_ = nullptr, *older_ = nullptr;
  QComboBox *of_ = nullptr, *metric_ = nullptr;
  ui::Chart* chart_ = nullptr;
};

}  // namespace insonate::train
