package rsal.jade;

import rsal.agent.bare.BareSystem;
import rsal.testkit.contract.BareSystemContract;

class BareJadeTest extends BareSystemContract {
    @Override
    protected BareSystem system() {
        return new BareJade();
    }
}
