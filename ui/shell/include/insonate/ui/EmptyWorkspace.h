#pragma once

#include <insonate/ui/Workspace.h>

#include <QStringList>

class QAction;
class QLabel;
class QVBoxLayout;

namespace insonate::ui {

/// A workspace without contents: says what will be here, and what to do now.
class EmptyWorkspace : public Workspace {
  Q_OBJECT

 public:
  struct Words {
    QString icon, title;
    QStringList paragraphs;
    QString status;
    QString helpPage;
  };
  explicit EmptyWorkspace(const Words& words, QWidget* parent = nullptr);

  /// Adds a button below the text; add the most usual action first. The action belongs to the caller.
  void offer(QAction* action);

  /// Shows the name of the case that is being opened in place of the title; empty restores the title.
  void showOpening(const QString& what);

  void setCase(std::shared_ptr<const PatientCase>) override {}
  QString statusText() const override { return words_.status; }
  QString helpPage() const override { return words_.helpPage; }

 private:
  Words words_;
  QVBoxLayout* column_;
  QLabel* title_;
  bool offered_ = false;
};

}  // namespace insonate::ui
