// The state of the secure link, beside the lock while the map stays as it is: suite, peer, age and fingerprint of
// the session, or why nothing is sealed. Not modal: closes by Esc, by a click elsewhere, or by its button, which leads to the
// panel.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QPointer>
#include <QtWidgets/QFrame>

class QLabel;
class QPushButton;

namespace skyseal::ui {

class LinkPopover : public QFrame
{
    Q_OBJECT

public:
    explicit LinkPopover(QWidget &window);

    /// Opens below `anchor`, or closes if it is open.
    void toggleAt(QWidget &anchor);
    void showViewState(const ViewState &view);

Q_SIGNALS:
    void panelRequested();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void place();
    void dismiss();

    QWidget &m_window;
    QPointer<QWidget> m_anchor;
    QPointer<QWidget> m_before; ///< had the focus
    QLabel *m_icon, *m_title, *m_facts;
    QPushButton *m_open;
};

} // namespace skyseal::ui
