/// Settings that people write: declared once as [rsal.settings.Parameter], handed on as [rsal.settings.Arguments].
/// Every error says where it is, what was read, what was expected and, where it can, what was meant.
@NullMarked
package rsal.settings;

import org.jspecify.annotations.NullMarked;
