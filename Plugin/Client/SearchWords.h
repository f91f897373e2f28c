// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SearchWords.h
 * Further names of filters, for ParaView's quick launch (Ctrl+Space).
 */
#ifndef SubdivisionObjects_SearchWords_h
#define SubdivisionObjects_SearchWords_h

#include <QWidget>

/**
 * Words that people type and that are in no label, such as "Catmull-Clark". Quick launch searches
 * the texts of actions only, so each word is an action. It makes the filter and chooses the scheme
 * of its name.
 */
class SearchWords : public QWidget
{
  Q_OBJECT
public:
  /// Adds them, where the client has a quick launch.
  static void Add();

private Q_SLOTS:
  /// Each is grey where the filter's entry of the menu is.
  void follow();

private:
  SearchWords();
};

#endif
