// The status strip under the menu: the most important state in one line. If the width is short, its items shorten, the least
// important first and the name of the cipher suite last.
#pragma once

#include "ui/view_state.h"
#include "ui/status/strip_item.h"

#include <QtWidgets/QWidget>

namespace skyseal::ui {

class StatusStrip : public QWidget
{
    Q_OBJECT

public:
    explicit StatusStrip(QWidget *parent = nullptr);

    void showViewState(const ViewState &view);
    /// Shows, in a few words and a sentence, that other stations may write through this one; both empty if they may not.
    void showSharing(const QString &word, const QString &sentence);

    /// At which what tells more about the lock is shown.
    QWidget *lock() const { return m_lock; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void lockClicked();
    void vehicleClicked();
    void linkClicked();
    void sharingClicked();

protected:
    void resizeEvent(QResizeEvent *) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *) override;

private:
    void showVehicle(const ViewState &view);
    void showLink(const ViewState &view);
    void noteQuality(const ViewState &view, double percent);
    void showLock(const ViewState &view);
    void arrange();

    int m_lineOf = -1; ///< system ID of the vehicle whose link the line shows
    StripItem *m_vehicle, *m_armed, *m_mode, *m_gps, *m_battery, *m_sharing, *m_lock, *m_link;
};

} // namespace skyseal::ui
