#pragma once

#include <insonate/ui/Workspace.h>

#include <QStringList>

class QAction;
class QLabel;
class QVBoxLayout;

namespace insonate::ui {

/// A page for a workspace without contents. It says what the workspace will show, and what to do now.
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

  /// Adds a button below the text. Add the most common action first. The caller owns the action.
  void addOpenAction(QAction* action);

  /// Shows a text about the case that is being opened in place of the title; an empty text restores the title.
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
