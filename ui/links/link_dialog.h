// Dialog to open a link: its type from the table of link types, the fields of that type, and the resulting URL, which is
// checked while typing. Main thread.
#pragma once

#include "core/engine/common/mavsec_settings.h"
#include "core/link/link_type.h"
#include "core/link/link_url.h"

#include <QtCore/QString>
#include <QtWidgets/QDialog>

#include <optional>
#include <vector>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace skyseal::ui {

class LinkDialog : public QDialog
{
    Q_OBJECT

public:
    /// Starts with the fields of `url`, if it is well-formed.
    explicit LinkDialog(const QString &url, QWidget *parent = nullptr);

    /// Links of this program: the dialog refuses one that would lead back to them.
    void setOwnLinks(std::vector<link::LinkUrl> own);

    /// The URL of the current fields; well-formed after the dialog was accepted.
    QString url() const;
    /// Set for a stream of MAVSec's published code, which is insecure; the link only receives then.
    std::optional<engine::MavsecSettings> mavsec() const;

private:
    void fill(const QString &url);
    const link::LinkType &type() const;
    void showKind();
    void showProtection();
    void check();
    void browse();
    void browseKey();
    QString problem() const;
    QString ownLinkProblem(const link::LinkUrl &wanted) const;

    std::vector<link::LinkUrl> m_own;
    QComboBox *m_kind;
    QLineEdit *m_host;
    QSpinBox *m_port;
    QLineEdit *m_path;
    QPushButton *m_browse;
    QComboBox *m_baud;
    QComboBox *m_protection; ///< the first item has no data: no MAVSec stream
    QLineEdit *m_key, *m_nonce, *m_counter;
    QPushButton *m_browseKey;
    QLabel *m_hostLabel, *m_portLabel, *m_pathLabel, *m_baudLabel, *m_keyLabel, *m_nonceLabel, *m_counterLabel;
    QLabel *m_result;
    QDialogButtonBox *m_buttons;
};

} // namespace skyseal::ui
