/// The HTTP server on the loopback address: who may do what, requests and answers, the page's files.
@NullMarked
package rsal.server.http;

import org.jspecify.annotations.NullMarked;
