package rsal.jason;

import rsal.agent.bare.BareLanguage;
import rsal.testkit.contract.BareLanguageContract;

class BareJasonTest extends BareLanguageContract {
    @Override
    protected BareLanguage language() {
        return new BareJason();
    }
}
