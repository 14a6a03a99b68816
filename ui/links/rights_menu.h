// The classes of messages that other stations may write (write= of skyseal-cli gateway --serve) as a check list. It stays open
// while boxes are ticked, by the mouse or the space bar. Main thread.
#pragma once

#include "core/engine/gateway/write_rights.h"

#include <QtWidgets/QMenu>

#include <vector>

namespace skyseal::ui {

class RightsMenu : public QMenu
{
    Q_OBJECT

public:
    explicit RightsMenu(QWidget *parent = nullptr);

    void setRights(const engine::WriteRights &rights);
    /// As ticked.
    engine::WriteRights rights() const;

Q_SIGNALS:
    /// The operator ticked or cleared a box.
    void rightsChosen(const skyseal::engine::WriteRights &rights);

protected:
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QAction *add(const QString &text, const QString &tip, const char *keyword);
    void toggleEverything(bool on);
    void toggleClass(bool on);

    QAction *m_everything;
    std::vector<QAction *> m_classes; ///< with the keyword as data
};

} // namespace skyseal::ui
