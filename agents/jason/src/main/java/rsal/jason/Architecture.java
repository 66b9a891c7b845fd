package rsal.jason;

import jason.JasonException;
import jason.architecture.AgArch;
import jason.asSemantics.ActionExec;
import jason.asSemantics.Message;
import java.time.Duration;
import rsal.time.Task;

/// Jason's link to the world, with RSAL behind: all that the interpreter asks for goes to the agent.
final class Architecture extends AgArch {
    private static final long serialVersionUID = 1;

    private final transient AgentSpeakAgent agent;
    private final String name; // as AgentSpeak writes it

    Architecture(AgentSpeakAgent agent, String name) {
        this.agent = agent;
        this.name = Terms.quoted(name);
    }

    Task after(Duration delay, Runnable task) {
        return agent.after(delay, task);
    }

    /// There is no plan at all for a goal.
    void unhandled(String goal, String where) {
        agent.unhandled(goal, where);
    }

    @Override
    public String getAgName() {
        return name;
    }

    @Override
    public void act(ActionExec action) {
        agent.act(action);
    }

    @Override
    public void sendMsg(Message message) throws JasonException {
        agent.post().send(message);
    }

    @Override
    public void broadcast(Message message) {
        agent.post().broadcast(message);
    }

    @Override
    public void wake() {
        agent.wake();
    }

    @Override
    public void wakeUpSense() {
        agent.wake();
    }

    @Override
    public void wakeUpDeliberate() {
        agent.wake();
    }

    @Override
    public void wakeUpAct() {
        agent.wake();
    }
}
