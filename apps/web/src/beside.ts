import BesideView from './beside/BesideView.svelte';
import './app.css';
import { show } from './show';

void show(BesideView);
