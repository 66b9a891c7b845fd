/// How an unpacked release starts fast: a cache of loaded classes, which [StartCache] makes once.
@NullMarked
package rsal.cli.start;

import org.jspecify.annotations.NullMarked;
