/// The agents of docs/tutorials/first-agent.md, word by word.
package own;
