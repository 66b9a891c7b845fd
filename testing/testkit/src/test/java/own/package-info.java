/// The host of docs/how-to/another-mas.md, word by word, and its test, which also keeps the contract and what hosts
/// with
/// threads build on as they should be.
@org.jspecify.annotations.NullMarked
package own;
