/// Agents written in AgentSpeak. Each is an [rsal.agent.Agent] around Jason's interpreter, which runs on the agent's
/// lane alone: no thread, no clock, no random number and no socket of Jason's own is used.
@NullMarked
package rsal.jason;

import org.jspecify.annotations.NullMarked;
